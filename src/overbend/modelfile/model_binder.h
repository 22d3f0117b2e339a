/// From checked values to the description of the model.
#pragma once

#include <string>

#include "model/description.h"
#include "modelfile/field_value.h"

namespace overbend {

/// Fills a description; values that are absent keep the defaults of the description. Files are resolved against the
/// folder of `source_file`.
Description bind_model(const FieldValue& root, const std::string& source_file);

}  // namespace overbend
