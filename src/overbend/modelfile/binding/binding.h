/// From the checked values of a model file to the objects that its keys fill.
#pragma once

#include <string>

#include "model/description/description.h"
#include "modelfile/schema/field_value.h"
#include "modelfile/schema/member.h"

namespace overbend {

/// Fills `target` with what a file gives below a group of the field table. What is left out stays as it is. Files are
/// resolved against the folder of `source_file`.
void bind_members(const FieldNode& node, const FieldValue& group, Target target, const std::string& source_file);

/// The description of a model. Left out, a key has the default of its member.
Description bind_model(const FieldValue& root, const std::string& source_file);

/// Where a file that the model names is found: beside the model file, unless its path is absolute.
std::string resolved_file(const std::string& file, const std::string& source_file);

}  // namespace overbend
