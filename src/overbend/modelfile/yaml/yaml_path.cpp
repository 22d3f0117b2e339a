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

/// Takes one step down; false when the path leads nowhere.
bool step(std::vector<YamlSpot>& spots, std::string& rest) {
  const YamlNode& at = *spots.back().node;
  if (at.kind == YamlNode::Kind::map) {
    const auto found = leading_key(at, rest);
    if (!found) return false;
    rest.erase(0, at.entries[*found].key.size());
    spots.push_back({&at.entries[*found].value, &at, *found});
    return true;
  }
  const auto found = at.kind == YamlNode::Kind::list ? leading_index(rest) : std::nullopt;
  if (!found || found->first >= at.items.size()) return false;
  rest.erase(0, found->second);
  spots.push_back({&at.items[found->first], &at, found->first});
  return true;
}

}  // namespace

std::optional<std::pair<std::size_t, std::size_t>> leading_index(const std::string& path) {
  const std::size_t close = path.find(']');
  if (path.empty() || path[0] != '[' || close == std::string::npos) return std::nullopt;
  std::size_t index = 0;
  const auto [end, fault] = std::from_chars(path.data() + 1, path.data() + close, index);
  if (fault != std::errc() || end != path.data() + close) return std::nullopt;
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
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t end = std::min(path.find_first_of(".[", at + 1), path.size());
    parts.push_back(path.substr(at, end - at));
    at = end + (end < path.size() && path[end] == '.' ? 1 : 0);
  }
  return parts;
}

}  // namespace overbend
