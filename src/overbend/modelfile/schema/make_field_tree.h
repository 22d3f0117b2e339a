/// Trees of tables of keys: the model file's, and those of files that are read by the same rules.
#pragma once

#include <typeindex>
#include <vector>

#include "modelfile/schema/field_tree.h"

namespace overbend {

/// The tree of a table. Table and root have to outlive it.
FieldNode make_field_tree(const std::vector<Field>& table, const Field& root);

/// Holds each row of a tree to the type of the object that it fills; `owner` is that of its root.
void check_types(const FieldNode& node, std::type_index owner);

}  // namespace overbend
