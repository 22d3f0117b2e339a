#include <set>

#include "base/text.h"
#include "modelfile/schema/field_value.h"
#include "modelfile/schema/scalar_reader.h"

namespace overbend {
namespace {

/// Traverses file and table together.
class FieldReader {
 public:
  FieldReader(std::string file, Diagnostics& diagnostics) : file_(std::move(file)), diagnostics_(diagnostics) {}

  std::optional<FieldValue> read(const YamlNode& node, const FieldNode& field, const std::string& path, int line) {
    if (node.kind == YamlNode::Kind::map && field.map != nullptr) return read_map(node, field, path, line);
    if (node.kind == YamlNode::Kind::list && field.list != nullptr) return read_list(node, field, path, line);
    if (node.kind == YamlNode::Kind::scalar && field.scalar != nullptr) {
      return read_value(node, *field.scalar, path, line);
    }
    add_error(line, path, shape_label(node), expected_shape(field), "");
    return std::nullopt;
  }

 private:
  void add_error(int line, const std::string& path, std::string found, std::string expected, std::string hint) {
    diagnostics_.add({Severity::error, file_, line, 0, path, std::move(found), std::move(expected), std::move(hint)});
  }

  static std::string shape_label(const YamlNode& node) {
    switch (node.kind) {
      case YamlNode::Kind::null:
        return "nothing";
      case YamlNode::Kind::list:
        return "a list";
      case YamlNode::Kind::map:
        return "a group of keys";
      case YamlNode::Kind::scalar:
        break;
    }
    return "'" + for_display(node.text) + "'";
  }

  static std::string expected_shape(const FieldNode& field) {
    std::vector<std::string> kinds;
    for (const Field* row : {field.scalar, field.map, field.list}) {
      if (row != nullptr) kinds.push_back(field_kind_label(*row));
    }
    return join_items(kinds, "or");
  }

  static std::string joined(const std::string& path, const std::string& key) {
    return path.empty() ? key : path + "." + key;
  }

  std::optional<FieldValue> read_value(const YamlNode& node, const Field& field, const std::string& path, int line) {
    ScalarReading reading = read_scalar(node, field);
    if (!reading.value) {
      add_error(node.line, path, reading.found, reading.expected, reading.hint);
      return std::nullopt;
    }
    if (!reading.unusual.empty()) {
      diagnostics_.add({Severity::warning, file_, node.line, 0, path,
                        reading.value->shown + " is unusual, typical is " + reading.unusual, "", "is the unit right?"});
    }
    if (!reading.remark.empty()) {
      diagnostics_.add({Severity::warning, file_, node.line, 0, path, reading.remark, "", ""});
    }
    reading.value->path = path;
    reading.value->line = line;
    return reading.value;
  }

  std::optional<FieldValue> read_list(const YamlNode& node, const FieldNode& field, const std::string& path, int line) {
    FieldValue list = container(FieldValue::Kind::list, path, line);
    const int count = static_cast<int>(node.items.size());
    if (count < field.list->min_items || count > field.list->max_items) {
      const bool exact = field.list->min_items == field.list->max_items;
      add_error(line, path, count == 0 ? "an empty list" : "a list of " + std::to_string(count),
                exact                           ? "exactly " + std::to_string(field.list->min_items) + " items"
                : count < field.list->min_items ? "at least " + std::to_string(field.list->min_items)
                                                : "at most " + std::to_string(field.list->max_items),
                "");
      return std::nullopt;
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const YamlNode& item = node.items[i];
      std::optional<FieldValue> value = read(item, *field.item, path + "[" + std::to_string(i) + "]", item.line);
      if (value) list.children.push_back(std::move(*value));
    }
    return list;
  }

  std::optional<FieldValue> read_map(const YamlNode& node, const FieldNode& field, const std::string& path, int line) {
    FieldValue map = container(FieldValue::Kind::map, path, line);
    if (!check_count(node, field, path, line)) return std::nullopt;
    std::set<std::string> seen;
    for (const YamlEntry& entry : node.entries) {
      const FieldNode* member = field.member(entry.key);
      if (member == nullptr || entry.key.empty()) {
        reject_key(entry, field, path, map);
      } else if (seen.insert(entry.key).second) {
        read_member(entry, *member, path, map);
      }
    }
    // Misspelt keys are not reported a second time as missing.
    for (const std::string& key : map.rejected_keys) {
      const FieldNode* member = field.member(key);
      if (member != nullptr && member->first().required) seen.insert(key);
    }
    if (!field.any_name()) complete(field, path, line, seen, map);
    return map;
  }

  void read_member(const YamlEntry& entry, const FieldNode& member, const std::string& path, FieldValue& map) {
    std::optional<FieldValue> value = read(entry.value, member, joined(path, for_display(entry.key)), entry.line);
    if (!value) {
      map.rejected_keys.push_back(entry.key);
      return;
    }
    value->key = entry.key;
    map.children.push_back(std::move(*value));
  }

  /// Returns false if the number of keys is outside the limits, in which case they are not checked individually.
  bool check_count(const YamlNode& node, const FieldNode& field, const std::string& path, int line) {
    const int count = static_cast<int>(node.entries.size());
    if (count >= field.map->min_items && count <= field.map->max_items) return true;
    const std::string found = count == 0 ? "an empty group" : "a group of " + std::to_string(count) + " keys";
    const std::string limit = std::to_string(field.map->max_items);
    if (field.map->max_items == kMaxItems && count > kMaxItems) {
      add_error(line, path, found, "at most " + limit, "");
      return false;
    }
    add_error(line, path, found,
              (count < field.map->min_items ? "at least " + std::to_string(field.map->min_items) : limit) + " of " +
                  join_items(field.member_names(), "or"),
              "");
    return true;
  }

  /// For a file that is not a model only the number of errors matters.
  void reject_key(const YamlEntry& entry, const FieldNode& field, const std::string& path, FieldValue& map) {
    constexpr int kExplained = 1000;
    if (diagnostics_.error_count() > kExplained) return add_error(entry.line, "", "an unknown key", "", "");
    const std::vector<std::string> known = field.member_names();
    const std::string near = nearest_word(entry.key, known);
    add_error(entry.line, joined(path, for_display(entry.key)), "an unknown key", join_choices(known),
              key_hint(entry.key, near));
    map.rejected_keys.push_back(near);
  }

  static std::string key_hint(const std::string& key, const std::string& near) {
    if (!near.empty()) return "did you mean '" + near + "'?";
    const bool digit = !key.empty() && key[0] >= '0' && key[0] <= '9';
    return digit ? "if this is a decimal comma: the decimal sign is a point" : "";
  }

  /// Completes the keys that were left out: a diagnostic if the value is required, otherwise the default.
  void complete(const FieldNode& field, const std::string& path, int line, const std::set<std::string>& seen,
                FieldValue& map) {
    for (const auto& member : field.members) {
      if (seen.count(member->key) != 0) continue;
      const Field& row = member->first();
      const std::string member_path = joined(path, member->key);
      if (row.required) {
        add_error(line, member_path, "nothing (the key is missing)", field_kind_label(row), required_hint(row));
      } else if (!row.fallback.empty()) {
        add_default(row, *member, member_path, line, map);
      } else if (row.kind == FieldKind::map && !member->any_name() && !member->has_required_member() &&
                 row.min_items == 0) {
        FieldValue group = container(FieldValue::Kind::map, member_path, line);
        group.key = member->key;
        group.given = false;
        complete(*member, member_path, line, {}, group);
        map.children.push_back(std::move(group));
      }
    }
  }

  static std::string required_hint(const Field& row) { return row.text.substr(0, row.text.find_last_of('.')); }

  void add_default(const Field& row, const FieldNode& member, const std::string& path, int line, FieldValue& map) {
    YamlNode node;
    node.kind = YamlNode::Kind::scalar;
    node.text = row.fallback;
    node.line = line;
    std::optional<FieldValue> value = read_value(node, row, path, line);
    if (!value) return;
    value->key = member.key;
    value->given = false;
    map.children.push_back(std::move(*value));
  }

  static FieldValue container(FieldValue::Kind kind, const std::string& path, int line) {
    FieldValue value;
    value.kind = kind;
    value.path = path;
    value.line = line;
    return value;
  }

  std::string file_;
  Diagnostics& diagnostics_;
};

}  // namespace

FieldValue read_fields(const YamlNode& root, const FieldNode& tree, const std::string& file, Diagnostics& diagnostics) {
  FieldReader reader(file, diagnostics);
  std::optional<FieldValue> value = reader.read(root, tree, "", root.line);
  return value ? std::move(*value) : FieldValue{};
}

}  // namespace overbend
