#include "serve/model/diagnose.h"

#include <algorithm>
#include <optional>

#include "base/yaml_document.h"
#include "modelfile/yaml/yaml_path.h"

namespace overbend {
namespace {

std::string diagnostic_message(const Diagnostic& diagnostic) {
  std::string text = diagnostic.expected.empty() ? diagnostic.found
                                                 : "found " + diagnostic.found + ", expected " + diagnostic.expected;
  if (!diagnostic.hint.empty()) text += "; " + diagnostic.hint;
  return text;
}

/// Returns the column of the value at `path` if it is in this line.
std::optional<int> column_of_value(const YamlNode& root, const std::string& path, int line) {
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(root, path, rest);
  if (!rest.empty() || spots.size() < 2) return std::nullopt;
  const YamlSpot& spot = spots.back();
  if (spot.node->kind != YamlNode::Kind::null && spot.node->line == line) return spot.node->column;
  if (spot.parent->kind == YamlNode::Kind::map && spot.parent->entries[spot.index].line == line) {
    return spot.parent->entries[spot.index].column;
  }
  return std::nullopt;
}

/// Line positions in a text.
class Lines {
 public:
  explicit Lines(const std::string& text) : text_(text) {
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', end + 1)) {
      begins_.push_back(end + 1);
    }
  }

  /// Returns the first non-blank column of a line.
  int first_column(int line) const {
    const auto number = static_cast<std::size_t>(line - 1);
    if (number >= begins_.size()) return 1;
    const std::size_t first = text_.find_first_not_of(' ', begins_[number]);
    return first == std::string::npos || text_[first] == '\n' ? 1 : static_cast<int>(first - begins_[number]) + 1;
  }

 private:
  const std::string& text_;
  std::vector<std::size_t> begins_ = {0};
};

constexpr std::size_t kMaxShown = 200;

Json listed(const Diagnostics& diagnostics, const std::string& text, const YamlNode* root) {
  Json all = Json::array();
  const std::vector<Diagnostic> sorted = diagnostics.sorted();
  const Lines lines(text);
  for (std::size_t i = 0; i < std::min(sorted.size(), kMaxShown); ++i) {
    const Diagnostic& diagnostic = sorted[i];
    const int line = std::max(diagnostic.line, 1);
    std::optional<int> column;
    if (diagnostic.column > 0) column = diagnostic.column;
    if (!column && root != nullptr) column = column_of_value(*root, diagnostic.key, line);
    all.push_back({{"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
                   {"line", line},
                   {"column", column.value_or(lines.first_column(line))},
                   {"key", diagnostic.key},
                   {"message", diagnostic_message(diagnostic)}});
  }
  const std::size_t count = std::max(sorted.size(), static_cast<std::size_t>(diagnostics.error_count()));
  if (count > kMaxShown) {
    all.push_back({{"severity", diagnostics.has_errors() ? "error" : "warning"},
                   {"line", sorted[kMaxShown - 1].line},
                   {"column", 1},
                   {"key", ""},
                   {"message", "and " + std::to_string(count - kMaxShown) + " more"}});
  }
  return all;
}

}  // namespace

Json diagnostics_json(const Diagnostics& diagnostics, const std::string& text) {
  Diagnostics ignored;
  const std::optional<YamlNode> root = diagnostics.sorted().empty() ? std::nullopt : parse_yaml(text, "", ignored);
  return listed(diagnostics, text, root ? &*root : nullptr);
}

Json diagnostics_json(const ModelReading& reading, const std::string& text) {
  return listed(reading.diagnostics, text, reading.tree.get());
}

}  // namespace overbend
