/// Table of all keys of the model file.
#pragma once

#include <vector>

#include "modelfile/schema/field_tree.h"

namespace overbend {

/// Returns every key, groups before their members, in the order of the reference page.
const std::vector<Field>& field_table();

/// Returns the tree of the table; its root has the keys of the top level.
const FieldNode& field_tree();

/// Returns the node of a path in the tree, as the table writes it.
const FieldNode& field_node(const std::string& path);

/// Version of the format read by this program, the value of the key `overbend`.
inline constexpr int kFormatVersion = 1;

}  // namespace overbend
