#include "modelfile/study_file/study_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/read_double.h"
#include "base/result_path.h"
#include "base/text.h"
#include "base/units.h"
#include "modelfile/checks/box_row_checks.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/fields/seek_values.h"
#include "modelfile/schema/scalar_row.h"
#include "modelfile/study_file/study_rows.h"
#include "modelfile/yaml/chosen_keys.h"

namespace overbend {
namespace {

/// "boxes[stinger 3].z" -> "boxes[].z", as the table has it.
std::string table_path(const std::vector<PathPart>& parts) {
  std::string path;
  for (const PathPart& part : parts) {
    path += part.item ? std::string("[]") : (path.empty() ? "" : ".") + part.text;
  }
  return path;
}

std::string nearest_key(const std::string& key) {
  const auto parts = split_result_path(key);
  std::vector<std::string> known;
  for (const Field& row : field_table()) {
    if (row.kind != FieldKind::map && row.kind != FieldKind::list) known.push_back(row.path);
  }
  const std::string near = nearest_word(parts ? table_path(*parts) : key, known);
  return near.empty() ? "items of lists are selected in brackets: supports.stinger.boxes[stinger 3].z"
                      : "did you mean '" + near + "'?";
}

bool is_numeric(const Field& row) {
  return row.kind == FieldKind::quantity || row.kind == FieldKind::number || row.kind == FieldKind::integer;
}

/// "330 deg" -> "deg".
std::string unit_in(const std::string& text) {
  const std::string_view trimmed = trim(text);
  const std::size_t sign = trimmed.starts_with('+') ? 1 : 0;
  double ignored = 0.0;
  const char* end = trimmed.data() + trimmed.size();
  const auto [stop, code] = read_double(trimmed.data() + sign, end, ignored);
  return std::string(trim(std::string_view(stop, static_cast<std::size_t>(end - stop))));
}

/// Returns the text as written in a model file: plain numbers without a per cent sign.
std::string written_value(const std::string& text, const Field& row) {
  if (row.kind != FieldKind::number || parse_number(text)) return text;
  return format_number(read_row_value(text, row).value->number, 17);
}

/// Returns a value of a range, in the unit of its first value, rounded to 12 digits to remove the rounding of summed
/// steps.
std::string range_value(double value, const std::string& unit, const Field& row) {
  constexpr int kDigits = 12;
  return row.kind == FieldKind::quantity ? format_quantity(value, row.unit, unit, kDigits)
                                         : format_number(value, kDigits);
}

const YamlNode* member(const YamlNode* group, const std::string& key) {
  if (group == nullptr) return nullptr;
  const auto found = ranges::find(group->entries, key, &YamlEntry::key);
  return found == group->entries.end() ? nullptr : &found->value;
}

/// Returns the parts of the key up to the first list of the model of which it chooses no item, or up to the first group
/// of which it chooses one; empty if it fits the model so far.
std::vector<PathPart> misread_container(const YamlNode& model, const std::vector<PathPart>& key) {
  const YamlNode* node = &model;
  for (std::size_t i = 0; i + 1 < key.size() && node != nullptr && !key[i].item; ++i) {
    node = member(node, key[i].text);
    const auto unexpected = key[i + 1].item ? YamlNode::Kind::map : YamlNode::Kind::list;
    if (node != nullptr && node->kind == unexpected) {
      return {key.begin(), key.begin() + static_cast<std::ptrdiff_t>(i) + 1};
    }
  }
  return {};
}

/// Reports a key that takes a list of the model for a group, or the reverse, with the key that fits.
bool reject_container(Checker& check, const FieldValue& value, const YamlNode& model,
                      const std::vector<PathPart>& key) {
  const std::vector<PathPart> container = misread_container(model, key);
  if (container.empty()) return false;
  const bool is_group = key[container.size()].item;
  std::vector<PathPart> fitting = key;
  const auto place = fitting.begin() + static_cast<std::ptrdiff_t>(container.size());
  if (is_group) {
    fitting.erase(place);
  } else {
    fitting.insert(place, {"0", true});
  }
  check.error(value, "'" + for_display(join_result_path(key)) + "'",
              join_result_path(container) + (is_group ? " without brackets, a group" : " with an item, a list") +
                  " in this model, as in " + join_result_path(fitting));
  return true;
}

/// Returns true for the radius of a ramp or stinger with listed boxes.
bool is_radius_of_listed_boxes(const YamlNode& model, const std::vector<PathPart>& key) {
  if (key.size() != 3 || key[0].text != "supports" || key[2].text != "radius") return false;
  const YamlNode* boxes = member(member(member(&model, "supports"), key[1].text), "boxes");
  return boxes == nullptr || boxes->kind != YamlNode::Kind::map;
}

class AxisReader {
 public:
  AxisReader(Checker& check, const FieldValue& item, const Field& row) : check_(check), item_(item), row_(row) {}

  std::vector<std::string> values() {
    const bool list = item_.mentions("values"), range = item_.mentions("from") || item_.mentions("to");
    if (list == range) {
      check_.error(item_, list ? "values given twice" : "no values", "values, or from and to");
      return {};
    }
    return list ? listed() : ranged();
  }

 private:
  std::vector<std::string> listed() {
    std::vector<std::string> texts;
    for (const FieldValue& value : Checker::items(item_, "values")) {
      const ScalarReading reading = read_row_value(value.text, row_);
      if (!reading.value) {
        check_.error(value, reading.found, reading.expected, reading.hint);
      } else {
        texts.push_back(written_value(value.text, row_));
      }
    }
    return texts;
  }

  std::vector<std::string> ranged() {
    if (!is_numeric(row_)) {
      check_.error(item_, "a range", "values: " + item_.get_text("key").value_or("") + " is " + field_kind_label(row_));
      return {};
    }
    for (const char* end : {"from", "to"}) {
      if (!item_.mentions(end)) check_.missing(item_, end, "the other end of the range");
    }
    const FieldValue *from = item_.find("from"), *to = item_.find("to");
    if (from == nullptr || to == nullptr) return {};
    const auto low = checked_number(check_, *from, row_), high = checked_number(check_, *to, row_);
    if (!low || !high) return {};
    if (*low == *high) {
      check_.error(*to, to->shown, "another value than the first, " + from->shown);
      return {};
    }
    const std::optional<double> step = find_step(*low, *high);
    return step ? stepped(*low, *high, *step, unit_in(from->text)) : std::vector<std::string>{};
  }

  std::optional<double> find_step(double low, double high) {
    const FieldValue* step = item_.find("step");
    const std::optional<std::int64_t> count = item_.get_integer("steps");
    if (item_.mentions("step") == item_.mentions("steps")) {
      check_.error(item_, count ? "step and steps" : "a range without a step", "either step or steps");
      return std::nullopt;
    }
    if (count) return (high - low) / static_cast<double>(*count - 1);
    if (step == nullptr) return std::nullopt;
    Field change = row_;
    change.range = {.low = 0.0, .low_open = true};
    const std::optional<double> size = checked_number(check_, *step, change);
    if (!size) return std::nullopt;
    if (std::abs(high - low) / *size > kMaxStudyCases) {
      check_.error(*step, step->shown, fmt::format("at most {:.0f} values", kMaxStudyCases));
      return std::nullopt;
    }
    return std::copysign(*size, high - low);
  }

  std::vector<std::string> stepped(double low, double high, double step, const std::string& unit) {
    constexpr double kRounding = 1e-9;
    const auto count = static_cast<std::size_t>(std::floor((high - low) / step + kRounding)) + 1;
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i) {
      texts.push_back(range_value(low + static_cast<double>(i) * step, unit, row_));
      const ScalarReading reading = read_row_value(texts.back(), row_);
      if (reading.value) continue;
      check_.error(item_, "the value '" + texts.back() + "'", reading.expected, reading.hint);
      return {};
    }
    return texts;
  }

  Checker& check_;
  const FieldValue& item_;
  const Field& row_;
};

const StudyAxis* find_axis(const std::vector<StudyAxis>& axes, const std::string& key) {
  const auto found = ranges::find(axes, key, &StudyAxis::key);
  return found == axes.end() ? nullptr : &*found;
}

/// Returns true if the chain of `with` references ends.
bool ends(const std::vector<StudyAxis>& axes, const StudyAxis& axis) {
  const StudyAxis* current = &axis;
  for (std::size_t i = 0; i <= axes.size() && current != nullptr; ++i) {
    if (current->with.empty()) return true;
    current = find_axis(axes, current->with);
  }
  return current == nullptr;
}

void check_with(Checker& check, const FieldValue& item, const StudyAxis& axis, const std::vector<StudyAxis>& axes) {
  const FieldValue* with = item.find("with");
  if (with == nullptr) return;
  const StudyAxis* partner = find_axis(axes, axis.with);
  if (partner == nullptr) {
    std::vector<std::string> keys;
    for (const StudyAxis& candidate : axes) keys.push_back(candidate.key);
    const std::string near = nearest_word(axis.with, keys);
    check.error(*with, with->shown, "the key of another axis", near.empty() ? "" : "did you mean '" + near + "'?");
  } else if (!ends(axes, axis)) {
    check.error(*with, with->shown, "an axis that does not depend on this one through `with`");
  } else if (partner->values.size() != axis.values.size() && !axis.values.empty() && !partner->values.empty()) {
    check.error(*with, fmt::format("{} values", axis.values.size()),
                fmt::format("as many as {} has, {}", partner->key, partner->values.size()));
  }
}

}  // namespace

const Field* StudyKeys::take(Checker& check, const FieldValue& value, const std::string& key) {
  const Field* row = scalar_row(key);
  const auto parts = split_result_path(key);
  if (row == nullptr || !parts) {
    check.error(value, "'" + for_display(key) + "'", "a key of the model file with a single value", nearest_key(key));
    return nullptr;
  }
  if (is_radius_of_listed_boxes(model_, *parts)) {
    check.error(value, "'" + key + "' of listed boxes", "the radius of a row of boxes", kListedBoxesHint);
    return nullptr;
  }
  if (reject_container(check, value, model_, *parts)) return nullptr;
  const std::vector<ChosenKey> chosen = chosen_keys(model_, *parts);
  if (chosen.empty()) {
    const std::vector<std::string> names = names_to_choose(model_, *parts);
    check.error(value, "'" + for_display(key) + "'", "an item in the list",
                names.empty() ? "the model has no such list" : "it has " + join_items(names, "and"));
    return nullptr;
  }
  for (const ChosenKey& choice : chosen) {
    if (taken_.insert(choice.path).second) continue;
    check.error(value, "'" + choice.name + "', which is set twice", "each key once");
    return nullptr;
  }
  return row;
}

std::optional<double> checked_number(Checker& check, const FieldValue& value, const Field& row) {
  const ScalarReading reading = read_row_value(value.text, row);
  if (!reading.value) {
    check.error(value, reading.found, reading.expected, reading.hint);
    return std::nullopt;
  }
  return reading.value->kind == FieldValue::Kind::integer ? static_cast<double>(reading.value->integer)
                                                          : reading.value->number;
}

std::vector<StudyAxis> read_axes(Checker& check, StudyKeys& keys) {
  std::vector<StudyAxis> axes;
  std::vector<const FieldValue*> items;
  for (const FieldValue& item : Checker::items(check.root(), "axes")) {
    const FieldValue* key = item.find("key");
    if (key == nullptr) continue;
    StudyAxis axis{key->text, {}, item.get_text("with").value_or(""), item.line};
    if (const Field* row = keys.take(check, *key, key->text)) axis.values = AxisReader(check, item, *row).values();
    axes.push_back(std::move(axis));
    items.push_back(&item);
  }
  for (std::size_t i = 0; i < axes.size(); ++i) check_with(check, *items[i], axes[i], axes);
  return axes;
}

}  // namespace overbend
