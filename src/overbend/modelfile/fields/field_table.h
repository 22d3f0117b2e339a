/// The table of all keys of the model file.
#pragma once

#include <vector>

#include "modelfile/schema/field_tree.h"

namespace overbend {

/// Every key, groups before their members, in the order of the reference page.
const std::vector<Field>& field_table();

/// The tree of the table; its root has the keys of the top level.
const FieldNode& field_tree();

/// The place of that path in the tree, as the table writes it.
const FieldNode& field_node(const std::string& path);

/// Version of the format that this program reads, the value of the key `overbend`.
inline constexpr int kFormatVersion = 1;

}  // namespace overbend
