#include "modelfile/field_tree.h"

#include <algorithm>
#include <stdexcept>

#include "modelfile/field_table.h"

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
  if (slot != nullptr) throw std::logic_error("two rows of one shape for " + field.path);
  slot = &field;
}

}  // namespace

const Field& FieldNode::first() const {
  const Field* best = nullptr;
  for (const Field* row : {scalar, map, list}) {
    if (row != nullptr && (best == nullptr || row < best)) best = row;  // rows lie in one array, in table order
  }
  if (best == nullptr) throw std::logic_error("no row in the field table for " + key);
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

const FieldNode& field_tree() {
  static const FieldNode kTree = [] {
    static const Field kRoot{.path = "", .kind = FieldKind::map, .text = "The model file."};
    FieldNode root;
    root.map = &kRoot;
    for (const Field& field : field_table()) insert(root, field);
    return root;
  }();
  return kTree;
}

}  // namespace overbend
