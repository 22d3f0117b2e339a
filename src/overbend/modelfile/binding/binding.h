/// Binding of the checked values of a model file to the objects that its keys fill.
#pragma once

#include <string>

#include "model/description/description.h"
#include "modelfile/schema/field_value.h"
#include "modelfile/schema/member.h"

namespace overbend {

/// Fills `target` from the values below a group of the field table. Members without a value are unchanged. Files are
/// resolved against the folder of `source_file`.
void bind_members(const FieldNode& node, const FieldValue& group, Target target, const std::string& source_file);

/// Returns the description of a model. Keys that are left out have the default of their member.
Description bind_model(const FieldValue& root, const std::string& source_file);

/// Returns the path of a file named in the model: relative to the model file, unless it is absolute.
std::string resolved_file(const std::string& file, const std::string& source_file);

}  // namespace overbend
