/// Table of all keys of a study file, read by the same rules as a model file.
#pragma once

#include <vector>

#include "modelfile/schema/field_tree.h"

namespace overbend {

/// Returns every key, groups before their members. modelfile/study_file/study_reader.cpp fills the members, since the
/// meaning of their texts depends on the model keys that they name.
const std::vector<Field>& study_table();

const FieldNode& study_tree();

/// Max. number of cases of a study.
inline constexpr double kMaxStudyCases = 1e6;

}  // namespace overbend
