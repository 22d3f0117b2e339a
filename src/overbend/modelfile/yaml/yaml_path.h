/// Paths such as "supports.ramp.boxes[2].x" in a YAML tree.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/yaml_document.h"

namespace overbend {

/// Position in the tree: the value, and the group or list that contains it.
struct YamlSpot {
  const YamlNode* node = nullptr;
  const YamlNode* parent = nullptr;  ///< Null for the root.
  std::size_t index = 0;             ///< Index among the parent's entries or items.
};

/// Descends the path as far as it exists. Returns the nodes passed, the root first; `rest` is the remaining path. Keys
/// may contain points: the longest match is used.
std::vector<YamlSpot> follow_path(const YamlNode& root, const std::string& path, std::string& rest);

/// "a.b[0].c" -> a, b, [0], c.
std::vector<std::string> path_parts(const std::string& path);

/// Returns 12 and the length of "[12]" for "[12].x"; empty if the path does not begin with an index.
std::optional<std::pair<std::size_t, std::size_t>> leading_index(const std::string& path);

}  // namespace overbend
