#include "modelfile/yaml/yaml_extent.h"

#include <algorithm>

namespace overbend {
namespace {

[[noreturn]] void throw_unsupported(const std::string& why) {
  throw std::runtime_error(why);
}

}  // namespace

YamlExtent::YamlExtent(const std::string& text) : text_(text), lines_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') lines_.push_back(i + 1);
  }
}

std::size_t YamlExtent::offset(int line, int column) const {
  if (line < 1 || line > static_cast<int>(lines_.size())) throw_unsupported("a position outside the text");
  std::size_t offset = lines_[static_cast<std::size_t>(line - 1)] + static_cast<std::size_t>(std::max(column, 1) - 1);
  if (line == 1 && text_.starts_with("\xEF\xBB\xBF")) offset += 3;  // the parser does not count a byte order mark
  return std::min(offset, text_.size());
}

std::size_t YamlExtent::line_begin(std::size_t offset) const {
  return *(std::upper_bound(lines_.begin(), lines_.end(), offset) - 1);
}

std::size_t YamlExtent::line_end(std::size_t offset) const {
  const std::size_t end = std::min(text_.find('\n', offset), text_.size());
  return end > offset && text_[end - 1] == '\r' ? end - 1 : end;
}

std::size_t YamlExtent::quoted_end(std::size_t offset) const {
  const char quote = text_[offset];
  for (std::size_t i = offset + 1; i < text_.size(); ++i) {
    if (quote == '"' && text_[i] == '\\') {
      ++i;
    } else if (text_[i] == quote) {
      if (quote == '"' || i + 1 >= text_.size() || text_[i + 1] != quote) return i + 1;
      ++i;  // '' stands for one
    }
  }
  throw_unsupported("a quote that is not closed");
}

std::size_t YamlExtent::scalar_end(const YamlNode& node) const {
  const std::size_t offset = begin(node);
  if (offset < text_.size() && (text_[offset] == '"' || text_[offset] == '\'')) return quoted_end(offset);
  if (text_.compare(offset, node.text.size(), node.text) != 0) {
    throw_unsupported("the value extends over several lines");
  }
  return offset + node.text.size();
}

bool YamlExtent::flow(const YamlNode& node) const {
  const std::size_t offset = begin(node);
  return offset < text_.size() && (text_[offset] == '{' || text_[offset] == '[');
}

std::size_t YamlExtent::closing(const YamlNode& node) const {
  const bool map = node.kind == YamlNode::Kind::map;
  std::size_t offset = begin(node) + 1;
  if (map && !node.entries.empty()) offset = end(node.entries.back());
  if (!map && !node.items.empty()) offset = end(node.items.back());
  for (; offset < text_.size(); ++offset) {
    if (text_[offset] == '#') offset = line_end(offset);
    if (offset < text_.size() && text_[offset] == (map ? '}' : ']')) return offset;
  }
  throw_unsupported("a bracket that is not closed");
}

std::size_t YamlExtent::after_colon(const YamlEntry& entry) const {
  std::size_t offset = begin(entry);
  if (offset >= text_.size()) throw_unsupported("a position outside the text");
  if (text_[offset] == '"' || text_[offset] == '\'') {
    offset = quoted_end(offset);
  } else if (text_.compare(offset, entry.key.size(), entry.key) == 0) {
    offset += entry.key.size();
  }
  offset = std::min(text_.find_first_not_of(" \t", offset), text_.size());
  if (offset == text_.size() || text_[offset] != ':') throw_unsupported("the key is written in an unusual way");
  return offset + 1;
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
      // '~' and 'null' have a position; an omitted value has none.
      if (!node.text.empty()) return scalar_end(node);
      break;
  }
  throw_unsupported("there is no value");
}

std::size_t YamlExtent::end(const YamlEntry& entry) const {
  const bool nothing = entry.value.kind == YamlNode::Kind::null && entry.value.text.empty();
  return nothing ? after_colon(entry) : end(entry.value);
}

}  // namespace overbend
