#include "modelfile/yaml/yaml_path.h"

#include <algorithm>
#include <charconv>

namespace overbend {
namespace {

std::optional<std::size_t> leading_key(const YamlNode& map, const std::string& rest) {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < map.entries.size(); ++i) {
    const std::string& key = map.entries[i].key;
    const bool fits = !key.empty() && rest.starts_with(key) &&
                      (rest.size() == key.size() || rest[key.size()] == '.' || rest[key.size()] == '[');
    if (fits && (!best || key.size() > map.entries[*best].key.size())) best = i;
  }
  return best;
}

/// Descends one level; returns false if the path does not exist.
bool step(std::vector<YamlSpot>& spots, std::string& rest) {
  const YamlNode& node = *spots.back().node;
  if (node.kind == YamlNode::Kind::map) {
    const auto found = leading_key(node, rest);
    if (!found) return false;
    rest.erase(0, node.entries[*found].key.size());
    spots.push_back({&node.entries[*found].value, &node, *found});
    return true;
  }
  const auto found = node.kind == YamlNode::Kind::list ? leading_index(rest) : std::nullopt;
  if (!found || found->first >= node.items.size()) return false;
  rest.erase(0, found->second);
  spots.push_back({&node.items[found->first], &node, found->first});
  return true;
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> leading_index(const std::string& path) {
  const std::size_t close = path.find(']');
  if (path.empty() || path[0] != '[' || close == std::string::npos) return std::nullopt;
  std::size_t index = 0;
  const auto [end, code] = std::from_chars(path.data() + 1, path.data() + close, index);
  if (code != std::errc() || end != path.data() + close) return std::nullopt;
  return std::pair{index, close + 1};
}

std::vector<YamlSpot> follow_path(const YamlNode& root, const std::string& path, std::string& rest) {
  std::vector<YamlSpot> spots = {{&root, nullptr, 0}};
  rest = path;
  while (!rest.empty() && step(spots, rest)) {
    if (rest.starts_with('.')) rest.erase(0, 1);
  }
  return spots;
}

std::vector<std::string> path_parts(const std::string& path) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start < path.size();) {
    const std::size_t end = std::min(path.find_first_of(".[", start + 1), path.size());
    parts.push_back(path.substr(start, end - start));
    start = end + (end < path.size() && path[end] == '.' ? 1 : 0);
  }
  return parts;
}

}  // namespace overbend
