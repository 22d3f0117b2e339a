/// Reader of one scalar of a model file by its row of the field table.
#pragma once

#include <optional>
#include <string>

#include "base/yaml_document.h"
#include "modelfile/schema/field.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// Scalar value, or the error found.
struct ScalarReading {
  std::optional<FieldValue> value;
  std::string found, expected, hint;  ///< Filled if there is no value.
  std::string unusual;                ///< Usual range, filled if a value outside it is accepted with a warning.
  std::string remark = {};            ///< Other warning about an accepted value.
};

ScalarReading read_scalar(const YamlNode& node, const Field& field);

}  // namespace overbend
