#include "serve/diagnose.h"

#include <algorithm>
#include <optional>

#include "base/yaml_document.h"
#include "modelfile/yaml_path.h"

namespace overbend {
namespace {

std::string message_of(const Diagnostic& diagnostic) {
  std::string text = diagnostic.expected.empty() ? diagnostic.found
                                                 : "found " + diagnostic.found + ", expected " + diagnostic.expected;
  if (!diagnostic.hint.empty()) text += "; " + diagnostic.hint;
  return text;
}

/// Column of the value with that path, if it is in that line.
std::optional<int> column_of_value(const YamlNode& root, const std::string& path, int line) {
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(root, path, rest);
  if (!rest.empty() || spots.size() < 2) return std::nullopt;
  const YamlSpot& at = spots.back();
  if (at.node->kind != YamlNode::Kind::null && at.node->line == line) return at.node->column;
  if (at.parent->kind == YamlNode::Kind::map && at.parent->entries[at.index].line == line) {
    return at.parent->entries[at.index].column;
  }
  return std::nullopt;
}

/// First column of a line that is not blank.
int first_column(const std::string& text, int line) {
  std::size_t begin = 0;
  for (int i = 1; i < line && begin != std::string::npos; ++i) {
    const std::size_t end = text.find('\n', begin);
    begin = end == std::string::npos ? end : end + 1;
  }
  if (begin == std::string::npos) return 1;
  const std::size_t at = text.find_first_not_of(' ', begin);
  return at == std::string::npos || text[at] == '\n' ? 1 : static_cast<int>(at - begin) + 1;
}

}  // namespace

Json diagnostics_json(const Diagnostics& diagnostics, const std::string& text) {
  Json all = Json::array();
  const std::vector<Diagnostic> sorted = diagnostics.sorted();
  if (sorted.empty()) return all;
  Diagnostics ignored;
  const std::optional<YamlNode> root = parse_yaml(text, "", ignored);
  for (const Diagnostic& diagnostic : sorted) {
    const int line = std::max(diagnostic.line, 1);
    std::optional<int> column;
    if (diagnostic.column > 0) column = diagnostic.column;
    if (!column && root) column = column_of_value(*root, diagnostic.key, line);
    all.push_back({{"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
                   {"line", line},
                   {"column", column.value_or(first_column(text, line))},
                   {"key", diagnostic.key},
                   {"message", message_of(diagnostic)}});
  }
  return all;
}

}  // namespace overbend
