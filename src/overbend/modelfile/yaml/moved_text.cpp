#include "modelfile/yaml/moved_text.h"

#include <optional>
#include <vector>

#include "base/yaml_document.h"
#include "modelfile/binding/binding.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/yaml/yaml_edit.h"
#include "modelfile/yaml/yaml_path.h"

namespace overbend {

std::string moved_text(const std::string& text, const std::string& file, const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  const std::optional<YamlNode> tree = parse_yaml(text, file, diagnostics);
  std::vector<YamlChange> changes;
  for (const Field& row : field_table()) {
    std::string rest;
    const std::vector<YamlSpot> spots = row.file && tree ? follow_path(*tree, row.path, rest) : std::vector<YamlSpot>{};
    if (spots.empty() || !rest.empty() || spots.back().node->kind != YamlNode::Kind::scalar) continue;
    const std::filesystem::path named = spots.back().node->text;
    if (named.is_absolute()) continue;
    // Absolute first: weakly_canonical() leaves a relative path relative if no part of it exists.
    const std::filesystem::path found =
        std::filesystem::weakly_canonical(std::filesystem::absolute(resolved_file(named.string(), file)));
    const std::filesystem::path from = std::filesystem::weakly_canonical(std::filesystem::absolute(folder));
    changes.push_back({row.path, YamlChange::Kind::scalar, found.lexically_relative(from).generic_string()});
  }
  return edit_yaml(text, changes);
}

}  // namespace overbend
