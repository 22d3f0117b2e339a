/// Paths such as "supports.ramp.boxes[2].x" in a YAML tree.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/yaml_document.h"

namespace overbend {

/// A place in the tree: the value, and the group or list that it is a part of.
struct YamlSpot {
  const YamlNode* node = nullptr;
  const YamlNode* parent = nullptr;  ///< Null for the root.
  std::size_t index = 0;             ///< Among the parent's entries or items.
};

/// Goes down the path as far as the tree does. Returns the places passed, the root first; `rest` is what is left of the
/// path. Keys may hold points: the longest that fits is taken.
std::vector<YamlSpot> follow_path(const YamlNode& root, const std::string& path, std::string& rest);

/// "a.b[0].c" -> a, b, [0], c.
std::vector<std::string> path_parts(const std::string& path);

/// "[12].x" -> 12 and the length of "[12]"; nothing when the path does not begin so.
std::optional<std::pair<std::size_t, std::size_t>> leading_index(const std::string& path);

}  // namespace overbend
