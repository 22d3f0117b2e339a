#include "modelfile/yaml/chosen_keys.h"

namespace overbend {
namespace {

const YamlNode* member_of(const YamlNode& group, const std::string& key) {
  for (const YamlEntry& entry : group.entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

std::string name_of(const YamlNode& item) {
  const YamlNode* name = member_of(item, "name");
  return name != nullptr ? name->text : std::string();
}

/// Goes down the tree, into every item that a part in brackets chooses. `at` is null where the text leaves a group out.
void choose(const YamlNode* at, const std::vector<NamePart>& parts, std::size_t next, const ChosenKey& above,
            std::vector<ChosenKey>& chosen) {
  if (next == parts.size()) {
    chosen.push_back(above);
    return;
  }
  const NamePart& part = parts[next];
  if (!part.item) {
    const std::string point = above.path.empty() ? "" : ".";
    choose(at != nullptr ? member_of(*at, part.text) : nullptr, parts, next + 1,
           {above.path + point + part.text, above.name + point + part.text}, chosen);
    return;
  }
  for (std::size_t i = 0; at != nullptr && i < at->entries.size(); ++i) {  // keys that are names, of a group
    const std::string& key = at->entries[i].key;
    if (!matches_pattern(part.text, key)) continue;
    choose(&at->entries[i].value, parts, next + 1, {above.path + "." + key, above.name + "[" + key + "]"}, chosen);
  }
  for (std::size_t i = 0; at != nullptr && i < at->items.size(); ++i) {
    const std::string name = name_of(at->items[i]), index = std::to_string(i);
    if (!chooses_item(part.text, i, name)) continue;
    choose(&at->items[i], parts, next + 1,
           {above.path + "[" + index + "]", above.name + "[" + (name.empty() ? index : name) + "]"}, chosen);
  }
}

}  // namespace

std::vector<ChosenKey> chosen_keys(const YamlNode& tree, const std::vector<NamePart>& name) {
  std::vector<ChosenKey> chosen;
  choose(&tree, name, 0, {}, chosen);
  return chosen;
}

std::vector<std::string> names_to_choose(const YamlNode& tree, const std::vector<NamePart>& name) {
  std::vector<const YamlNode*> here{&tree};
  for (const NamePart& part : name) {
    std::vector<const YamlNode*> below;
    std::vector<std::string> names;
    for (const YamlNode* at : here) {
      if (const YamlNode* member = part.item ? nullptr : member_of(*at, part.text)) below.push_back(member);
      for (std::size_t i = 0; part.item && i < at->entries.size(); ++i) {
        if (matches_pattern(part.text, at->entries[i].key)) below.push_back(&at->entries[i].value);
        names.push_back(at->entries[i].key);
      }
      for (std::size_t i = 0; part.item && i < at->items.size(); ++i) {
        const std::string item = name_of(at->items[i]);
        if (chooses_item(part.text, i, item)) below.push_back(&at->items[i]);
        names.push_back(item.empty() ? "an item" : item);
      }
    }
    if (below.empty()) return names;
    here = std::move(below);
  }
  return {};
}

}  // namespace overbend
