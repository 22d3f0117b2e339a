#include "base/result_path.h"

#include <algorithm>
#include <charconv>

namespace overbend {

std::optional<std::vector<PathPart>> split_result_path(std::string_view name) {
  constexpr std::size_t kMaxLength = 4000, kMaxParts = 64;
  if (name.size() > kMaxLength) return std::nullopt;
  std::vector<PathPart> parts;
  while (!name.empty() && parts.size() <= kMaxParts) {
    const bool item = name.front() == '[';
    if (item) name.remove_prefix(1);
    const std::size_t end = item ? name.find(']') : std::min(name.find_first_of(".["), name.size());
    if (end == std::string_view::npos || end == 0) return std::nullopt;
    parts.push_back({std::string(name.substr(0, end)), item});
    name.remove_prefix(end + (item ? 1 : 0));
    if (name.empty() || name.front() == '[') continue;
    if (name.front() != '.' || name.size() == 1 || name[1] == '[') return std::nullopt;
    name.remove_prefix(1);
  }
  if (parts.empty() || parts.size() > kMaxParts || parts.front().item) return std::nullopt;
  return parts;
}

std::string join_result_path(const std::vector<PathPart>& parts) {
  std::string name;
  for (const PathPart& part : parts) {
    if (part.item) {
      name.append("[").append(part.text).append("]");
    } else {
      name.append(name.empty() ? "" : ".").append(part.text);
    }
  }
  return name;
}

std::optional<std::size_t> item_index(const std::string& text) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return index;
}

bool matches_pattern(std::string_view pattern, std::string_view text) {
  std::size_t star = std::string_view::npos, p = 0, t = 0, resumed = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      resumed = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {  // extend the match of the last star by one character
      p = star + 1;
      t = ++resumed;
    } else {
      return false;
    }
  }
  return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

bool chooses_item(const std::string& text, std::size_t index, const std::string& name) {
  if (const std::optional<std::size_t> wanted = item_index(text)) return index == *wanted;
  if (const std::size_t dots = text.find(".."); dots != std::string::npos) {
    const auto first = item_index(text.substr(0, dots)), last = item_index(text.substr(dots + 2));
    if (first && last) return index >= *first && index <= *last;
  }
  return matches_pattern(text, name);
}

}  // namespace overbend
