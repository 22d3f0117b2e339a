/// One scalar of a model file against its row of the field table.
#pragma once

#include <optional>
#include <string>

#include "base/yaml_document.h"
#include "modelfile/schema/field.h"
#include "modelfile/schema/field_value.h"

namespace overbend {

/// A scalar read, or what is wrong with it.
struct ScalarReading {
  std::optional<FieldValue> value;
  std::string found, expected, hint;  ///< Filled when there is no value.
  std::string unusual;                ///< Filled when the value is accepted with a remark: the usual range.
  std::string remark = {};            ///< Another remark on an accepted value.
};

ScalarReading read_scalar(const YamlNode& node, const Field& field);

}  // namespace overbend
