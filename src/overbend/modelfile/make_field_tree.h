/// Trees of other tables than the model file's.
#pragma once

#include <vector>

#include "modelfile/field_tree.h"

namespace overbend {

/// A tree of the rows of a file that is read by the same rules as the model file. Both have to outlive it.
FieldNode make_field_tree(const std::vector<Field>& table, const Field& root);

}  // namespace overbend
