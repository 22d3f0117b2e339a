#include "modelfile/yaml/chosen_keys.h"

namespace overbend {
namespace {

const YamlNode* find_member(const YamlNode& group, const std::string& key) {
  for (const YamlEntry& entry : group.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

std::string find_item_name(const YamlNode& item) {
  const YamlNode* name = find_member(item, "name");
  return name != nullptr ? name->text : std::string();
}

/// Descends the tree into every item selected by a part in brackets. `node` is null where the text omits a group.
void choose(const YamlNode* node, const std::vector<PathPart>& parts, std::size_t next, const ChosenKey& above,
            std::vector<ChosenKey>& chosen) {
  if (next == parts.size()) {
    chosen.push_back(above);
    return;
  }
  const PathPart& part = parts[next];
  if (!part.item) {
    const std::string point = above.path.empty() ? "" : ".";
    choose(node != nullptr ? find_member(*node, part.text) : nullptr, parts, next + 1,
           {above.path + point + part.text, above.name + point + part.text}, chosen);
    return;
  }
  for (std::size_t i = 0; node != nullptr && i < node->entries.size(); ++i) {  // keys of a group that are free names
    const std::string& key = node->entries[i].key;
    if (!matches_pattern(part.text, key)) continue;
    choose(&node->entries[i].value, parts, next + 1, {above.path + "." + key, above.name + "[" + key + "]"}, chosen);
  }
  for (std::size_t i = 0; node != nullptr && i < node->items.size(); ++i) {
    const std::string name = find_item_name(node->items[i]), index = std::to_string(i);
    if (!chooses_item(part.text, i, name)) continue;
    choose(&node->items[i], parts, next + 1,
           {above.path + "[" + index + "]", above.name + "[" + (name.empty() ? index : name) + "]"}, chosen);
  }
}

}  // namespace

std::vector<ChosenKey> chosen_keys(const YamlNode& tree, const std::vector<PathPart>& name) {
  std::vector<ChosenKey> chosen;
  choose(&tree, name, 0, {}, chosen);
  return chosen;
}

std::vector<std::string> names_to_choose(const YamlNode& tree, const std::vector<PathPart>& name) {
  std::vector<const YamlNode*> level{&tree};
  for (const PathPart& part : name) {
    std::vector<const YamlNode*> below;
    std::vector<std::string> names;
    for (const YamlNode* node : level) {
      if (const YamlNode* member = part.item ? nullptr : find_member(*node, part.text)) below.push_back(member);
      for (std::size_t i = 0; part.item && i < node->entries.size(); ++i) {
        if (matches_pattern(part.text, node->entries[i].key)) below.push_back(&node->entries[i].value);
        names.push_back(node->entries[i].key);
      }
      for (std::size_t i = 0; part.item && i < node->items.size(); ++i) {
        const std::string item = find_item_name(node->items[i]);
        if (chooses_item(part.text, i, item)) below.push_back(&node->items[i]);
        names.push_back(item.empty() ? "an item" : item);
      }
    }
    if (below.empty()) return names;
    level = std::move(below);
  }
  return {};
}

}  // namespace overbend
