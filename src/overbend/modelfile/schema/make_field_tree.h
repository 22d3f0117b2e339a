/// Trees of key tables: of the model file and of other files with the same rules.
#pragma once

#include <typeindex>
#include <vector>

#include "modelfile/schema/field_tree.h"

namespace overbend {

/// Returns the tree of a table. Table and root must outlive it.
FieldNode make_field_tree(const std::vector<Field>& table, const Field& root);

/// Checks each row of a tree against the type of the object that it fills; `owner` is the type of the root. Throws on a
/// mismatch.
void check_types(const FieldNode& node, std::type_index owner);

}  // namespace overbend
