#include "orcaflex/object.h"

#include <algorithm>
#include <limits>

#include "base/text.h"
#include "base/units.h"

namespace overbend::orcaflex {
namespace {

bool has_default(const YamlNode& node) {
  return node.kind == YamlNode::Kind::null;
}

void add_error(const Origin& origin, int line, const std::string& key, const std::string& found,
               const std::string& expected, const std::string& hint = {}) {
  const std::string path = origin.path.empty() ? key : origin.path + "." + key;
  origin.diagnostics->add({Severity::error, origin.file, line, 0, path, found, expected, hint});
}

std::optional<double> read_number(const YamlNode& node, const Origin& origin, const std::string& key) {
  if (has_default(node)) return std::nullopt;
  if (node.kind == YamlNode::Kind::scalar) {
    if (node.text == "Infinity") return std::numeric_limits<double>::infinity();
    if (const std::optional<double> value = parse_number(node.text)) return value;
    add_error(origin, node.line, key, "'" + for_display(node.text) + "'", "a number",
              "a name stands for variable data, which are not read: give the value itself");
  } else {
    add_error(origin, node.line, key, "a list or group", "a number");
  }
  return std::nullopt;
}

std::vector<std::string> column_names(const std::string& key) {
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin <= key.size()) {
    const std::size_t end = std::min(key.find(',', begin), key.size());
    names.emplace_back(trim(std::string_view(key).substr(begin, end - begin)));
    begin = end + 1;
  }
  return names;
}

}  // namespace

Table::Table(const YamlEntry& entry, Origin origin) : columns_(column_names(entry.key)), origin_(std::move(origin)) {
  for (const YamlNode& row : entry.value.items) {
    const std::size_t cells = row.kind == YamlNode::Kind::list ? row.items.size() : 1;
    if (cells > columns_.size()) {
      add_error(origin_, row.line, columns_.front(), std::to_string(cells) + " values in a row",
                std::to_string(columns_.size()) + " columns: " + for_display(trim(entry.key), 200));
      continue;
    }
    rows_.push_back(&row);
  }
}

const YamlNode* Table::cell(std::size_t row, const std::string& column) const {
  const auto found = std::find(columns_.begin(), columns_.end(), column);
  if (found == columns_.end()) return nullptr;
  const auto index = static_cast<std::size_t>(found - columns_.begin());
  if (rows_[row]->kind != YamlNode::Kind::list) return index == 0 ? rows_[row] : nullptr;
  return index < rows_[row]->items.size() ? &rows_[row]->items[index] : nullptr;
}

std::optional<double> Table::number(std::size_t row, const std::string& column) const {
  const YamlNode* node = cell(row, column);
  return node != nullptr ? read_number(*node, origin_, column) : std::nullopt;
}

std::string Table::text(std::size_t row, const std::string& column) const {
  const YamlNode* node = cell(row, column);
  return node != nullptr && node->kind == YamlNode::Kind::scalar ? node->text : std::string();
}

const YamlNode* Object::member(const std::string& key) const {
  for (const YamlEntry& entry : node_->entries) {
    if (entry.key == key) return &entry.value;
  }
  return nullptr;
}

Origin Object::inside(const std::string& key) const {
  return {origin_.file, origin_.path.empty() ? key : origin_.path + "." + key, origin_.diagnostics};
}

int Object::find_line(const std::string& key) const {
  const YamlNode* node = member(key);
  return node != nullptr ? node->line : node_->line;
}

std::optional<double> Object::number(const std::string& key) const {
  const YamlNode* node = member(key);
  return node != nullptr ? read_number(*node, origin_, key) : std::nullopt;
}

std::string Object::text(const std::string& key, const std::string& otherwise) const {
  const YamlNode* node = member(key);
  return node != nullptr && node->kind == YamlNode::Kind::scalar ? node->text : otherwise;
}

std::vector<std::optional<double>> Object::numbers(const std::string& key) const {
  std::vector<std::optional<double>> values;
  const YamlNode* node = member(key);
  if (node == nullptr) return values;
  if (node->kind == YamlNode::Kind::scalar) return {read_number(*node, origin_, key)};
  for (const YamlNode& item : node->items) values.push_back(read_number(item, origin_, key));
  return values;
}

Vec3 Object::triple(const std::string& key) const {
  const std::vector<std::optional<double>> values = numbers(key);
  if (!values.empty() && values.size() != 3) {
    reject(key, std::to_string(values.size()) + " numbers", "[x, y, z]");
    return Vec3::Zero();
  }
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < values.size(); ++i) point(static_cast<Eigen::Index>(i)) = values[i].value_or(0.0);
  return point;
}

std::vector<Object> Object::objects(const std::string& key) const {
  std::vector<Object> result;
  const YamlNode* node = member(key);
  if (node == nullptr) return result;
  for (const YamlNode& item : node->items) {
    if (item.kind == YamlNode::Kind::map) result.emplace_back(item, inside(key));
  }
  return result;
}

std::optional<Object> Object::object(const std::string& key) const {
  const YamlNode* node = member(key);
  if (node == nullptr || node->kind != YamlNode::Kind::map) return std::nullopt;
  return Object(*node, inside(key));
}

std::optional<Table> Object::table(const std::string& column) const {
  for (const YamlEntry& entry : node_->entries) {
    const std::vector<std::string> names = column_names(entry.key);
    if (std::find(names.begin(), names.end(), column) != names.end()) return Table(entry, origin_);
  }
  return std::nullopt;
}

void Object::reject(const std::string& key, const std::string& found, const std::string& expected,
                    const std::string& hint) const {
  add_error(origin_, find_line(key), key, found, expected, hint);
}

}  // namespace overbend::orcaflex
