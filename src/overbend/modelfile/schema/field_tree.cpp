#include "modelfile/schema/field_tree.h"

#include <algorithm>

#include "base/require.h"
#include "modelfile/schema/make_field_tree.h"

namespace overbend {
namespace {

/// "pipe.coatings[].name" -> pipe, coatings, [], name.
std::vector<std::string> split_path(const std::string& path) {
  std::vector<std::string> parts;
  std::size_t start = 0;
  while (start <= path.size()) {
    const std::size_t dot = std::min(path.find('.', start), path.size());
    std::string part = path.substr(start, dot - start);
    const bool items = part.ends_with("[]");
    if (items) part.resize(part.size() - 2);
    parts.push_back(part);
    if (items) parts.emplace_back("[]");
    start = dot + 1;
  }
  return parts;
}

FieldNode& child(FieldNode& node, const std::string& key) {
  if (key == "[]") {
    if (!node.item) node.item = std::make_unique<FieldNode>();
    node.item->key = key;
    return *node.item;
  }
  for (const auto& member : node.members) {
    if (member->key == key) return *member;
  }
  node.members.push_back(std::make_unique<FieldNode>());
  node.members.back()->key = key;
  return *node.members.back();
}

void insert(FieldNode& root, const Field& field) {
  FieldNode* node = &root;
  for (const std::string& part : split_path(field.path)) node = &child(*node, part);
  const Field*& slot = field.kind == FieldKind::map    ? node->map
                       : field.kind == FieldKind::list ? node->list
                                                       : node->scalar;
  if (slot != nullptr) broken_promise("a place has one row of each shape: " + field.path);
  slot = &field;
}

void check_type(const FieldNode& node, const Field* row, std::type_index owner) {
  if (row == nullptr) return;
  const Member& member = row->member;
  const bool container = row == node.map || row == node.list;
  if (!member.put && !container) broken_promise("every row of the field table fills a member: " + row->path);
  if (member.put && member.owner != typeid(void) && member.owner != owner) {
    broken_promise("a row fills a member of what its group fills: " + row->path);
  }
  if (!container || (member.put && member.below == typeid(void))) return;  // other readers bind the values below
  const std::type_index below = member.put ? member.below : owner;
  if (row == node.list) {
    check_types(*node.item, below);
  } else {
    for (const auto& child : node.members) check_types(*child, below);
  }
}

}  // namespace

void check_types(const FieldNode& node, std::type_index owner) {
  for (const Field* row : {node.scalar, node.map, node.list}) check_type(node, row, owner);
}

const Field& FieldNode::first() const {
  const Field* best = nullptr;
  for (const Field* row : {scalar, map, list}) {
    // pointers compare in table order: rows are in one array
    if (row != nullptr && (best == nullptr || row < best)) best = row;
  }
  if (best == nullptr) broken_promise("every place has a row in the field table: " + key);
  return *best;
}

const FieldNode* FieldNode::member(const std::string& name) const {
  for (const auto& m : members) {
    if (m->key == name || m->key == "*") return m.get();
  }
  return nullptr;
}

std::vector<std::string> FieldNode::member_names() const {
  std::vector<std::string> names;
  for (const auto& m : members) names.push_back(m->key);
  return names;
}

bool FieldNode::has_required_member() const {
  return std::any_of(members.begin(), members.end(), [](const auto& m) { return m->first().required; });
}

FieldNode make_field_tree(const std::vector<Field>& table, const Field& root) {
  FieldNode tree;
  tree.map = &root;
  for (const Field& field : table) insert(tree, field);
  return tree;
}

const FieldNode& place_in(const FieldNode& root, const std::string& path) {
  const FieldNode* node = &root;
  for (const std::string& part : split_path(path)) {
    node = part == "[]" ? node->item.get() : node->member(part);
    if (node == nullptr) broken_promise("the field table has the path " + path);
  }
  return *node;
}

}  // namespace overbend
