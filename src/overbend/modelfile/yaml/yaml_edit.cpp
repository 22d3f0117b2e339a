#include "modelfile/yaml/yaml_edit.h"

#include <algorithm>
#include <optional>

#include "base/interruption.h"
#include "base/ranges.h"
#include "base/text.h"
#include "modelfile/yaml/yaml_extent.h"
#include "modelfile/yaml/yaml_path.h"

namespace overbend {
namespace {

using Kind = YamlNode::Kind;

/// Returns the value nested in groups and lists of the parts from `first`, in flow style: "{b: [{c: 3}]}".
std::string nested(const std::vector<std::string>& parts, std::size_t first, std::string value) {
  for (std::size_t i = parts.size(); i > first; --i) {
    const std::string& part = parts[i - 1];
    if (part[0] == '[' && part != "[0]") throw YamlEditError("a list starts with item [0]");
    const bool item = part[0] == '[';
    std::string around = item ? "[" : "{" + yaml_scalar(part) + ": ";
    around.append(value).append(item ? "]" : "}");
    value = std::move(around);
  }
  return value;
}

/// Applies one change to a text.
class Editor {
 public:
  Editor(const std::string& text, const YamlNode& root) : text_(text), root_(root), extent_(text) {}

  std::string set(const std::string& path, const std::string& value) const {
    std::string rest;
    const std::vector<YamlSpot> spots = follow_path(root_, path, rest);
    const YamlSpot& spot = spots.back();
    if (rest.empty()) return replace(spot, value);
    const std::vector<std::string> parts = path_parts(rest);
    if (spot.node->kind == Kind::map) return insert_key(*spot.node, parts, value);
    if (spot.node->kind == Kind::list) return append(*spot.node, parts, value);
    return replace(spot, nested(parts, 0, value));
  }

  std::string remove(const std::string& path) const {
    std::string rest;
    std::vector<YamlSpot> spots = follow_path(root_, path, rest);
    if (!rest.empty()) return text_;
    // Also removes the group or list that would become empty.
    while (spots.size() > 2 && members(*spots.back().parent) == 1) spots.pop_back();
    const YamlSpot& spot = spots.back();
    if (spot.parent == nullptr || members(*spot.parent) == 1) throw YamlEditError("the model would be empty");
    return extent_.flow(*spot.parent) ? remove_flow(spot) : remove_block(spot);
  }

 private:
  static std::size_t members(const YamlNode& node) {
    return node.kind == Kind::map ? node.entries.size() : node.items.size();
  }

  std::string with(std::size_t from, std::size_t to, const std::string& replacement) const {
    return text_.substr(0, from) + replacement + text_.substr(to);
  }

  std::string line_break() const { return text_.find("\r\n") != std::string::npos ? "\r\n" : "\n"; }

  static std::string blanks(int column) { return std::string(static_cast<std::size_t>(std::max(column, 1) - 1), ' '); }

  std::string replace(const YamlSpot& spot, const std::string& value) const {
    if (spot.parent == nullptr) throw YamlEditError("the path is empty");
    const YamlNode& node = *spot.node;
    const bool block = (node.kind == Kind::map || node.kind == Kind::list) && !extent_.flow(node);
    const bool nothing = node.kind == Kind::null && node.text.empty();
    if (!block && !nothing) {
      const std::size_t begin = extent_.begin(node);
      // A plain text with a quotation mark (12" pipe) or a backslash changes its meaning within quotation marks.
      const bool stays_quoted =
          node.quoted && value[0] != '{' && value[0] != '[' && value.find_first_of("\"\\") == std::string::npos;
      return with(begin, extent_.end(node), stays_quoted ? '"' + value + '"' : value);
    }
    if (spot.parent->kind == Kind::list) {
      if (nothing) throw YamlEditError("there is an empty item");
      return with(extent_.begin(node), extent_.end(node), value);
    }
    const std::size_t colon = extent_.after_colon(spot.parent->entries[spot.index]);
    if (nothing) return with(colon, colon, " " + value);
    // Keeps the comment behind the key and removes the lines below it.
    const std::size_t head_end = extent_.line_end(colon), end = extent_.line_end(extent_.end(node));
    return text_.substr(0, colon) + " " + value + text_.substr(colon, head_end - colon) + text_.substr(end);
  }

  std::string insert_key(const YamlNode& map, const std::vector<std::string>& parts, const std::string& value) const {
    if (parts[0][0] == '[') throw YamlEditError("a group has keys, not numbered items");
    if (extent_.flow(map)) {
      const std::string entry = yaml_scalar(parts[0]) + ": " + nested(parts, 1, value);
      const std::size_t offset = map.entries.empty() ? extent_.begin(map) + 1 : extent_.end(map.entries.back());
      return with(offset, offset, (map.entries.empty() ? "" : ", ") + entry);
    }
    return insert_lines(extent_.end(map.entries.back()), block_lines(parts, map.column, value));
  }

  /// Returns "a:", "  b: value"; from the first list on in flow style, its first item on a line of its own if it is a
  /// group.
  std::vector<std::string> block_lines(const std::vector<std::string>& parts, int column,
                                       const std::string& value) const {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::string head = blanks(column + 2 * static_cast<int>(i)) + yaml_scalar(parts[i]) + ":";
      if (i + 2 == parts.size() && parts[i + 1] == "[0]" && value[0] == '{') {
        lines.push_back(head);
        lines.push_back(blanks(column + 2 * static_cast<int>(i) + 2) + "- " + value);
        break;
      }
      if (i + 1 == parts.size() || parts[i + 1][0] == '[') {
        lines.push_back(head + " " + nested(parts, i + 1, value));
        break;
      }
      lines.push_back(head);
    }
    return lines;
  }

  /// Inserts after the line that contains `end`.
  std::string insert_lines(std::size_t end, const std::vector<std::string>& lines) const {
    const std::size_t offset = extent_.line_end(end);
    std::string added;
    for (const std::string& line : lines) added += line_break() + line;
    if (offset == text_.size()) added += line_break();
    return with(offset, offset, added);
  }

  std::string append(const YamlNode& list, const std::vector<std::string>& parts, const std::string& value) const {
    const auto index = leading_index(parts[0]);
    if (!index) {
      throw YamlEditError("the list of " + std::to_string(list.items.size()) +
                          " has numbered items, not keys: name one, "
                          "such as [0]." +
                          parts[0]);
    }
    if (index->first != list.items.size()) {
      throw YamlEditError("the list has " + std::to_string(list.items.size()) + " items; the next is [" +
                          std::to_string(list.items.size()) + "]");
    }
    const std::string item = nested(parts, 1, value);
    if (!extent_.flow(list)) return insert_lines(extent_.end(list), {blanks(list.column) + "- " + item});
    const std::size_t offset = list.items.empty() ? extent_.begin(list) + 1 : extent_.end(list.items.back());
    return with(offset, offset, (list.items.empty() ? "" : ", ") + item);
  }

  std::size_t begin(const YamlNode& parent, std::size_t i) const {
    return parent.kind == Kind::map ? extent_.begin(parent.entries[i]) : extent_.begin(parent.items[i]);
  }
  std::size_t end(const YamlNode& parent, std::size_t i) const {
    return parent.kind == Kind::map ? extent_.end(parent.entries[i]) : extent_.end(parent.items[i]);
  }

  std::string remove_flow(const YamlSpot& spot) const {
    if (spot.index + 1 < members(*spot.parent)) {
      return with(begin(*spot.parent, spot.index), begin(*spot.parent, spot.index + 1), "");
    }
    return with(end(*spot.parent, spot.index - 1), end(*spot.parent, spot.index), "");
  }

  std::string remove_block(const YamlSpot& spot) const {
    std::size_t from = begin(*spot.parent, spot.index);
    if (spot.parent->kind == Kind::list) from = text_.rfind('-', from - 1);
    const std::size_t line = extent_.line_begin(from);
    if (text_.find_first_not_of(' ', line) != from) {
      // The first key of "- a: 1" follows the dash; the next key takes its position.
      if (spot.index + 1 == members(*spot.parent)) throw YamlEditError("the layout of this item is unusual");
      return with(from, begin(*spot.parent, spot.index + 1), "");
    }
    const std::size_t end_of_line = text_.find('\n', end(*spot.parent, spot.index));
    return with(line, end_of_line == std::string::npos ? text_.size() : end_of_line + 1, "");
  }

  const std::string& text_;
  const YamlNode& root_;
  YamlExtent extent_;
};

std::optional<YamlNode> parsed(const std::string& text) {
  Diagnostics diagnostics;
  std::optional<YamlNode> root = parse_yaml(text, "", diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  return root;
}

bool same(const YamlNode& a, const YamlNode& b) {
  return a.kind == b.kind && a.text == b.text && a.items.size() == b.items.size() &&
         a.entries.size() == b.entries.size() && std::equal(a.items.begin(), a.items.end(), b.items.begin(), same) &&
         std::equal(a.entries.begin(), a.entries.end(), b.entries.begin(),
                    [](const YamlEntry& x, const YamlEntry& y) { return x.key == y.key && same(x.value, y.value); });
}

/// Returns true if the edited text contains the change: detects a layout that the editor misinterprets.
bool has_change(const std::string& text, const YamlChange& change, const std::string& written) {
  const std::optional<YamlNode> root = parsed(text);
  if (!root) return false;
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(*root, change.path, rest);
  if (change.kind == YamlChange::Kind::remove) return true;
  if (!rest.empty()) return false;
  if (change.kind == YamlChange::Kind::scalar) {
    return spots.back().node->kind == Kind::scalar && spots.back().node->text == change.value;
  }
  const std::optional<YamlNode> wanted = parsed(written);
  return wanted && same(*wanted, *spots.back().node);
}

std::string edited(const std::string& text, const YamlChange& change) {
  const std::optional<YamlNode> root = parsed(text);
  if (!root || root->kind != Kind::map || root->entries.empty()) {
    throw YamlEditError("the text cannot be read as YAML; correct it first");
  }
  const Editor editor(text, *root);
  const bool remove = change.kind == YamlChange::Kind::remove;
  const std::string written = change.kind == YamlChange::Kind::flow ? change.value : yaml_scalar(change.value);
  std::string edited_text = remove ? editor.remove(change.path) : editor.set(change.path, written);
  if (!has_change(edited_text, change, written)) throw YamlEditError("the text has an unusual layout at this key");
  return edited_text;
}

/// Returns the node at a path, created if its last key is missing in a group; null if that is impossible.
YamlNode* node_at(YamlNode& root, const std::string& path) {
  std::string rest;
  const std::vector<YamlSpot> spots = follow_path(root, path, rest);
  YamlNode* node = &root;
  for (std::size_t i = 1; i < spots.size(); ++i) {
    node = node->kind == Kind::map ? &node->entries[spots[i].index].value : &node->items[spots[i].index];
  }
  if (rest.empty()) return node;
  if (node->kind != Kind::map || rest.find_first_of(".[") != std::string::npos) return nullptr;
  node->entries.push_back({rest, node->line, node->column, {}});
  return &node->entries.back().value;
}

/// Returns true if a path is deeper than any key; each level would add a line and increase the indentation.
bool exceeds_max_depth(const std::string& path) {
  constexpr std::size_t kMaxLength = 4000;
  constexpr std::ptrdiff_t kMaxDepth = 64;
  const auto steps = ranges::count_if(path, [](char c) { return c == '.' || c == '['; });
  return path.size() > kMaxLength || steps > kMaxDepth;
}

}  // namespace

bool edit_tree(YamlNode& root, const std::vector<YamlChange>& changes) {
  for (const YamlChange& change : changes) {
    check_interruption();
    if (exceeds_max_depth(change.path)) return false;
    YamlNode* node = change.kind == YamlChange::Kind::scalar ? node_at(root, change.path) : nullptr;
    if (node == nullptr || !node->items.empty() || !node->entries.empty()) return false;
    if (node->line == 0) node->line = root.line;
    node->kind = Kind::scalar;
    node->text = change.value;
    node->quoted = false;
  }
  return true;
}

std::string yaml_scalar(const std::string& text) {
  const std::optional<YamlNode> alone = parsed("[" + text + "]");
  const bool plain = alone && alone->kind == Kind::list && alone->items.size() == 1 &&
                     alone->items[0].kind == Kind::scalar && !alone->items[0].quoted && alone->items[0].text == text;
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '\n') {
      quoted += "\\n";
      continue;
    }
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string edit_yaml(const std::string& text, const std::vector<YamlChange>& changes) {
  std::string edited_text = text;
  for (const YamlChange& change : changes) {
    check_interruption();
    if (exceeds_max_depth(change.path)) {
      throw YamlEditError("'" + for_display(change.path) + "' cannot be set: it is deeper than any key of a model");
    }
    try {
      edited_text = edited(edited_text, change);
    } catch (const std::runtime_error& error) {
      throw YamlEditError(
          "'" + change.path + "' cannot be set: " + error.what() +
          (std::string(error.what()).find("correct it") == std::string::npos ? "; change it in the text" : ""));
    }
  }
  return edited_text;
}

}  // namespace overbend
