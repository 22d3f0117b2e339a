/// The table of all keys of a study file, read by the same rules as a model file.
#pragma once

#include <vector>

#include "modelfile/schema/field_tree.h"

namespace overbend {

/// Every key, groups before their members. Members are filled by modelfile/study_file/study_reader.cpp, for what their
/// texts mean hangs on the keys of the model that they name.
const std::vector<Field>& study_table();

const FieldNode& study_tree();

/// Most cases of a study.
inline constexpr double kMostCases = 1e6;

}  // namespace overbend
