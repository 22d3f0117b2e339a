/// Keys of a model's text that a name with items in brackets selects.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result_path.h"
#include "base/yaml_document.h"

namespace overbend {

/// Key of one item: its path with indices, and with item names.
struct ChosenKey {
  std::string path, name;
};

/// Returns every key of the tree that the name selects, its items by index, name or pattern. Keys missing in their
/// group, or whose groups are missing, are included; items missing in a list are not.
std::vector<ChosenKey> chosen_keys(const YamlNode& tree, const std::vector<PathPart>& name);

/// Returns the names, or "an item", of the first list in which no item is selected; empty if there is no such list.
std::vector<std::string> names_to_choose(const YamlNode& tree, const std::vector<PathPart>& name);

}  // namespace overbend
