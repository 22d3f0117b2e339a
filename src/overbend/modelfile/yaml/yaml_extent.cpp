#include "modelfile/yaml/yaml_extent.h"

#include <algorithm>

namespace overbend {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw std::runtime_error(why);
}

}  // namespace

YamlExtent::YamlExtent(const std::string& text) : text_(text), lines_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') lines_.push_back(i + 1);
  }
}

std::size_t YamlExtent::offset(int line, int column) const {
  if (line < 1 || line > static_cast<int>(lines_.size())) refuse("a place outside the text");
  std::size_t at = lines_[static_cast<std::size_t>(line - 1)] + static_cast<std::size_t>(std::max(column, 1) - 1);
  if (line == 1 && text_.starts_with("\xEF\xBB\xBF")) at += 3;  // the parser does not count a byte order mark
  return std::min(at, text_.size());
}

std::size_t YamlExtent::line_begin(std::size_t at) const {
  return *(std::upper_bound(lines_.begin(), lines_.end(), at) - 1);
}

std::size_t YamlExtent::line_end(std::size_t at) const {
  const std::size_t end = std::min(text_.find('\n', at), text_.size());
  return end > at && text_[end - 1] == '\r' ? end - 1 : end;
}

std::size_t YamlExtent::quoted_end(std::size_t at) const {
  const char quote = text_[at];
  for (std::size_t i = at + 1; i < text_.size(); ++i) {
    if (quote == '"' && text_[i] == '\\') {
      ++i;
    } else if (text_[i] == quote) {
      if (quote == '"' || i + 1 >= text_.size() || text_[i + 1] != quote) return i + 1;
      ++i;  // '' stands for one
    }
  }
  refuse("a quote that is not closed");
}

std::size_t YamlExtent::scalar_end(const YamlNode& node) const {
  const std::size_t at = begin(node);
  if (at < text_.size() && (text_[at] == '"' || text_[at] == '\'')) return quoted_end(at);
  if (text_.compare(at, node.text.size(), node.text) != 0) refuse("there is a text of several lines");
  return at + node.text.size();
}

bool YamlExtent::flow(const YamlNode& node) const {
  const std::size_t at = begin(node);
  return at < text_.size() && (text_[at] == '{' || text_[at] == '[');
}

std::size_t YamlExtent::closing(const YamlNode& node) const {
  const bool map = node.kind == YamlNode::Kind::map;
  std::size_t at = begin(node) + 1;
  if (map && !node.entries.empty()) at = end(node.entries.back());
  if (!map && !node.items.empty()) at = end(node.items.back());
  for (; at < text_.size(); ++at) {
    if (text_[at] == '#') at = line_end(at);
    if (at < text_.size() && text_[at] == (map ? '}' : ']')) return at;
  }
  refuse("a bracket that is not closed");
}

std::size_t YamlExtent::after_colon(const YamlEntry& entry) const {
  std::size_t at = begin(entry);
  if (at >= text_.size()) refuse("a place outside the text");
  if (text_[at] == '"' || text_[at] == '\'') {
    at = quoted_end(at);
  } else if (text_.compare(at, entry.key.size(), entry.key) == 0) {
    at += entry.key.size();
  }
  at = std::min(text_.find_first_not_of(" \t", at), text_.size());
  if (at == text_.size() || text_[at] != ':') refuse("a key is written there in an unusual way");
  return at + 1;
}

std::size_t YamlExtent::end(const YamlNode& node) const {
  switch (node.kind) {
    case YamlNode::Kind::scalar:
      return scalar_end(node);
    case YamlNode::Kind::map:
      return flow(node) ? closing(node) + 1 : end(node.entries.back());
    case YamlNode::Kind::list:
      if (flow(node)) return closing(node) + 1;
      if (node.items.empty() || node.items.back().kind == YamlNode::Kind::null) break;
      return end(node.items.back());
    case YamlNode::Kind::null:
      // '~' and 'null' have a place of their own; where nothing is written there is none.
      if (!node.text.empty()) return scalar_end(node);
      break;
  }
  refuse("there is nothing there");
}

std::size_t YamlExtent::end(const YamlEntry& entry) const {
  const bool nothing = entry.value.kind == YamlNode::Kind::null && entry.value.text.empty();
  return nothing ? after_colon(entry) : end(entry.value);
}

}  // namespace overbend
