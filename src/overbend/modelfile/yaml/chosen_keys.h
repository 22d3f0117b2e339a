/// The keys of a model's text that a name with items in brackets stands for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/name_parts.h"
#include "base/yaml_document.h"

namespace overbend {

/// A key of one item: its path with indices, and with names for people.
struct ChosenKey {
  std::string path, name;
};

/// Every key of the tree that the name chooses, its items by index, name or pattern. A key that is left out in its
/// group, or whose groups are, counts as chosen; an item that the list does not have does not.
std::vector<ChosenKey> chosen_keys(const YamlNode& tree, const std::vector<NamePart>& name);

/// Names, or "an item", of the items of the first list of the name in which none is chosen; empty where there is no
/// such list.
std::vector<std::string> names_to_choose(const YamlNode& tree, const std::vector<NamePart>& name);

}  // namespace overbend
