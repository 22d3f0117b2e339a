#include "modelfile/yaml/input_place.h"

#include <optional>
#include <vector>

#include "modelfile/yaml/yaml_path.h"

namespace overbend {

std::string input_place(const std::string& file, const std::string& text, const std::string& key) {
  Diagnostics ignored;
  const std::optional<YamlNode> root = text.empty() ? std::nullopt : parse_yaml(text, file, ignored);
  if (!root) return key;
  std::string rest;
  const YamlSpot spot = follow_path(*root, key, rest).back();
  const bool named = spot.parent != nullptr && spot.parent->kind == YamlNode::Kind::map;
  const int line = named ? spot.parent->entries[spot.index].line : spot.node->line;
  return file + ":" + std::to_string(line) + ": " + key;
}

}  // namespace overbend
