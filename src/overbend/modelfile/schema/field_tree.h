/// The field table as a tree, the shape in which a model file is walked.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "modelfile/schema/field.h"

namespace overbend {

/// One place in the model file with the shapes it may have.
struct FieldNode {
  std::string key;                ///< Last part of the path; "[]" for the items of a list, "*" for any name.
  const Field* scalar = nullptr;  ///< Row for a single value, if it may be one.
  const Field* map = nullptr;     ///< Row for a group of keys, if it may be one.
  const Field* list = nullptr;    ///< Row for a list, if it may be one.
  std::vector<std::unique_ptr<FieldNode>> members;  ///< Of the group, in the table's order.
  std::unique_ptr<FieldNode> item;                  ///< Of the list.

  /// The row that speaks for the place: the first in the table.
  const Field& first() const;
  /// Member of that name (or the one for any name); null when there is none.
  const FieldNode* member(const std::string& name) const;
  bool any_name() const { return members.size() == 1 && members.front()->key == "*"; }
  std::vector<std::string> member_names() const;
  /// True when something below must be given, so that leaving the group out cannot be filled by defaults.
  bool has_required_member() const;
};

/// The place of a path in a tree, as its table writes it. A path that is not there is a broken promise.
const FieldNode& place_in(const FieldNode& root, const std::string& path);

}  // namespace overbend
