#include "serve/model/model_fields.h"

#include <algorithm>

#include "modelfile/fields/field_table.h"
#include "modelfile/schema/scalar_reader.h"
#include "report/page/json_number.h"

namespace overbend {
namespace {

using Kind = YamlNode::Kind;

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

/// Returns the value in SI units; null if it is not a valid number.
Json value_in_si(const YamlNode& node, const Field& row) {
  const ScalarReading reading = read_scalar(node, row);
  if (!reading.value) return nullptr;
  if (reading.value->kind == FieldValue::Kind::integer) return reading.value->integer;
  return reading.value->kind == FieldValue::Kind::number ? Json(seven_digits(reading.value->number)) : Json(nullptr);
}

constexpr std::size_t kMaxItems = 200;     ///< Maximum number of items of a list.
constexpr std::size_t kMaxFields = 20000;  ///< Maximum number of fields in total.

/// Traverses the table of fields and the text in parallel.
class Lister {
 public:
  Json take() { return std::move(list_); }

  void members(const FieldNode& field, const YamlNode* map, const std::string& path) {
    if (field.any_name()) {
      if (map == nullptr) return;
      for (std::size_t i = 0; i < std::min(map->entries.size(), kMaxItems); ++i) {
        place(*field.members.front(), &map->entries[i], joined(path, map->entries[i].key));
      }
      return;
    }
    for (const auto& member : field.members) {
      place(*member, map == nullptr ? nullptr : find(*map, member->key), joined(path, member->key));
    }
  }

 private:
  static std::string joined(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
  }

  static const YamlEntry* find(const YamlNode& map, const std::string& key) {
    const auto found =
        std::find_if(map.entries.begin(), map.entries.end(), [&](const YamlEntry& entry) { return entry.key == key; });
    return found == map.entries.end() ? nullptr : &*found;
  }

  /// Returns the row for the shape used in the text, or the first row.
  static const Field& find_field_row(const FieldNode& field, const YamlNode* node) {
    const Field* row = nullptr;
    if (node != nullptr && node->kind == Kind::scalar) row = field.scalar;
    if (node != nullptr && node->kind == Kind::map) row = field.map;
    if (node != nullptr && node->kind == Kind::list) row = field.list;
    return row != nullptr ? *row : field.first();
  }

  void place(const FieldNode& field, const YamlEntry* entry, const std::string& path) {
    value(field, entry == nullptr ? nullptr : &entry->value, entry == nullptr ? 0 : entry->line, path);
  }

  void value(const FieldNode& field, const YamlNode* node, int line, const std::string& path) {
    if (list_.size() >= kMaxFields) return;
    const Field& row = find_field_row(field, node);
    add(row, node, line, path);
    if (node == nullptr) {
      // The members of a missing group are offered if it can only be a group, or a list of such groups.
      if (field.map == &field.first() && field.scalar == nullptr) members(field, nullptr, path);
    } else if (node->kind == Kind::map && field.map != nullptr) {
      members(field, node, path);
    } else if (node->kind == Kind::list && field.list != nullptr) {
      for (std::size_t i = 0; i < std::min(node->items.size(), kMaxItems); ++i) {
        value(*field.item, &node->items[i], node->items[i].line, path + "[" + std::to_string(i) + "]");
      }
    }
  }

  void add(const Field& row, const YamlNode* node, int line, const std::string& path) {
    const bool scalar = node != nullptr && node->kind == Kind::scalar;
    Json item = {{"path", path},
                 {"kind", enum_name(row.kind)},
                 {"value", scalar ? Json(node->text) : Json(nullptr)},
                 {"si", scalar ? value_in_si(*node, row) : Json(nullptr)},
                 {"unit", text_or_null(row.show)},
                 {"default", text_or_null(row.fallback)},
                 {"given", node != nullptr},
                 {"line", line > 0 ? Json(line) : Json(nullptr)},
                 {"text", row.text},
                 {"choices", row.choices},
                 {"required", row.required},
                 {"left_out", row.fallback_text},
                 {"range", field_range_label(row, row.range)}};
    if (node != nullptr && node->kind == Kind::list) item["count"] = node->items.size();
    list_.push_back(std::move(item));
  }

  Json list_ = Json::array();
};

}  // namespace

Json model_fields(const YamlNode* root) {
  if (root == nullptr || root->kind != Kind::map) return Json::array();
  Lister lister;
  lister.members(field_tree(), root, "");
  return lister.take();
}

}  // namespace overbend
