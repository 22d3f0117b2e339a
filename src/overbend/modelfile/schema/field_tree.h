/// Field table as a tree, which has the structure of a model file.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "modelfile/schema/field.h"

namespace overbend {

/// Position in the model file with its allowed shapes.
struct FieldNode {
  std::string key;                ///< Last part of the path; "[]" for the items of a list, "*" for any name.
  const Field* scalar = nullptr;  ///< Row for a single value; null if not allowed.
  const Field* map = nullptr;     ///< Row for a group of keys; null if not allowed.
  const Field* list = nullptr;    ///< Row for a list; null if not allowed.
  std::vector<std::unique_ptr<FieldNode>> members;  ///< Members of the group, in table order.
  std::unique_ptr<FieldNode> item;                  ///< Item of the list.

  /// Returns the first row of this position in the table.
  const Field& first() const;
  /// Returns the member of that name (or the one for any name); null if there is none.
  const FieldNode* member(const std::string& name) const;
  bool any_name() const { return members.size() == 1 && members.front()->key == "*"; }
  std::vector<std::string> member_names() const;
  /// Returns true if a member below is required, so that defaults cannot replace a missing group.
  bool has_required_member() const;
};

/// Returns the position of a path in a tree, as its table writes it. Throws if the path does not exist.
const FieldNode& place_in(const FieldNode& root, const std::string& path);

}  // namespace overbend
