#include <algorithm>

#include "base/result_path.h"
#include "base/text.h"
#include "model/description/operation_names.h"
#include "model/description/seek_operations.h"
#include "modelfile/checks/box_row_checks.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/fields/seek_values.h"
#include "resultfiles/summary/named_results.h"

namespace overbend {
namespace {

constexpr const char* kNoStages =
    "a goal seek evaluates the normal lay configuration, not the stages of its operation, except for a lift or a pull";

bool of_operation(const std::string& path) {
  return path.starts_with("operation.") || path.starts_with("stages[");
}

bool evaluates_stages(const Checker& check) {
  const std::optional<std::string> word = check.root().get_text("operation.type");
  const std::optional<OperationType> type = find_operation_type(word.value_or(""));
  return type && is_seek_over_stages(*type);
}

/// Returns the members of a group that is given once or as a list.
std::vector<const FieldValue*> groups(const FieldValue& seek, const std::string& key) {
  const FieldValue* found = seek.find(key);
  if (found == nullptr) return {};
  if (found->kind != FieldValue::Kind::list) return {found};
  std::vector<const FieldValue*> all;
  for (const FieldValue& item : found->children) all.push_back(&item);
  return all;
}

/// Returns true if the text selects the item: by index or name in a list, by key in a group with free names.
bool is_selected(const FieldValue& group, std::size_t index, const std::string& text) {
  const FieldValue& item = group.children[index];
  if (group.kind == FieldValue::Kind::map) return item.given && matches_pattern(text, item.key);
  return chooses_item(text, index, item.get_text("name").value_or(""));
}

std::string item_label(const FieldValue& group, const FieldValue& item) {
  return group.kind == FieldValue::Kind::map ? item.key : item.get_text("name").value_or("an item");
}

/// Returns true if the lists of the model have items for the key; otherwise sets `names` to those of the first list
/// without a match.
bool has_items(const FieldValue& node, const std::vector<PathPart>& parts, std::size_t next,
               std::vector<std::string>& names) {
  if (next == parts.size()) return true;
  const PathPart& part = parts[next];
  if (!part.item) {
    const FieldValue* member = node.find(part.text);
    // A missing key can be set in its group; a missing list has no items.
    if (member == nullptr) {
      return std::none_of(parts.begin() + static_cast<std::ptrdiff_t>(next), parts.end(),
                          [](const PathPart& later) { return later.item; });
    }
    return has_items(*member, parts, next + 1, names);
  }
  bool any = false;
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    if (is_selected(node, i, part.text)) any = has_items(node.children[i], parts, next + 1, names) || any;
  }
  if (!any && names.empty()) {
    for (const FieldValue& item : node.children) {
      if (item.given) names.push_back(item_label(node, item));
    }
  }
  return any;
}

void check_value(Checker& check, const FieldValue* value, const Field& row) {
  if (value == nullptr) return;
  const ScalarReading reading = read_row_value(value->text, row);
  if (!reading.value) check.error(*value, reading.found, reading.expected, reading.hint);
}

void check_bounds(Checker& check, const FieldValue& variable, const Field& row) {
  const FieldValue *from = variable.find("from"), *to = variable.find("to"), *within = variable.find("within");
  if (within != nullptr ? from != nullptr || to != nullptr : from == nullptr || to == nullptr) {
    check.error(variable, within != nullptr ? "bounds given twice" : "no lower and upper bound",
                "from and to, or within");
    return;
  }
  check_value(check, from, row);
  check_value(check, to, row);
  Field change = row;
  change.range = {.low = 0.0, .low_open = true};
  check_value(check, within, change);
  if (from == nullptr) return;
  const ScalarReading low = read_row_value(from->text, row), high = read_row_value(to->text, row);
  if (low.value && high.value && low.value->number >= high.value->number) {
    check.error(*to, to->shown, "more than the lower bound, " + from->shown);
  }
}

void check_variable(Checker& check, const FieldValue& variable) {
  const FieldValue* key = variable.find("key");
  if (key == nullptr) return;
  const Field* row = varied_row(key->text);
  if (row == nullptr) {
    check.error(*key, key->shown, "a key of the model file with a quantity or a number, such as tensioner.tension",
                "items of lists are selected in brackets: supports.stinger.boxes[stinger 3].z");
    return;
  }
  if (of_operation(key->text) && !evaluates_stages(check)) {
    check.error(*key, key->shown, "a key of the laid line itself", kNoStages);
    return;
  }
  if (key->text == "supports.ramp.radius" || key->text == "supports.stinger.radius") {
    const FieldValue* structure = check.root().find(key->text.substr(0, key->text.rfind('.')));
    if (structure == nullptr || find_box_row(*structure) == nullptr) {
      check.error(*key, key->shown + " of listed boxes", "the radius of a row of boxes", kListedBoxesHint);
      return;
    }
  }
  std::vector<std::string> names;
  if (!has_items(check.root(), split_result_path(key->text).value(), 0, names)) {
    check.error(*key, key->shown, "an item in the list",
                names.empty() ? "the model has no such list" : "it has " + join_items(names, "and"));
    return;
  }
  check_bounds(check, variable, *row);
}

/// Returns the most similar result name, with the list items of the given name.
std::string nearest_result(const std::string& name) {
  const std::string path = parsed_result_name(name).path;
  const std::string near = nearest_word(path, result_paths());
  return near.empty() ? "paths are those of summary.json, such as static.sagbend.max_bending_stress"
                      : "did you mean '" + near + "'?";
}

/// Returns the names of the stages, and of the entries under "lines" and "davits" in the stages of a lift.
std::vector<std::string> names_in_list(const Checker& check, const std::string& list) {
  std::vector<std::string> names;
  const std::vector<FieldValue>& items = Checker::items(check.root(), list == "stages" ? "operation.stages" : "lines");
  for (std::size_t i = 0; i < items.size(); ++i) {
    names.push_back(items[i].get_text("name").value_or("stage " + std::to_string(i + 1)));
  }
  return names;
}

/// Reports the part of a result name that does not exist in the stages, with the existing names.
bool check_names_in_stage(Checker& check, const FieldValue& result, const std::vector<PathPart>& parts) {
  for (std::size_t i = 1; i + 1 < parts.size(); ++i) {
    const std::string& list = parts[i].text;
    if (parts[i].item || (list != "stages" && list != "lines" && list != "davits")) continue;
    const std::vector<std::string> names = names_in_list(check, list);
    const PathPart& name = parts[i + 1];
    bool any = false;
    for (std::size_t k = 0; k < names.size(); ++k) {
      any = any || (list == "stages" ? chooses_item(name.text, k, names[k]) : matches_pattern(name.text, names[k]));
    }
    if (any || names.empty()) continue;  // generated stages have no names
    check.error(result, result.shown, "the name of " + std::string(list == "stages" ? "a stage" : "a line"),
                "there is no '" + for_display(name.text) + "'; the model has " + join_items(names, "and"));
    return false;
  }
  return true;
}

/// Checks that results of a lift or a pull are results of its stages.
bool check_stage_result(Checker& check, const FieldValue& result) {
  const std::string path = parsed_result_name(result.text).path;
  const std::optional<std::vector<PathPart>> parts = split_result_path(path);
  if (path.starts_with("checks.")) return true;
  if (parts && path.starts_with("operation.stages[")) return check_names_in_stage(check, result, *parts);
  check.error(
      result, result.shown, "a result of a stage of the operation",
      "such as operation.stages[0].lines.pipe.first_end.z of a lift, operation.stages[0].tension.winch of a pull");
  return false;
}

bool check_result(Checker& check, const FieldValue* result) {
  if (result == nullptr) return false;
  const bool stages = evaluates_stages(check);
  if (!stages && of_operation(parsed_result_name(result->text).path)) {
    check.error(*result, result->shown, "the path of a number in summary.json of a static analysis", kNoStages);
    return false;
  }
  if (result_row(result->text)) return !stages || check_stage_result(check, *result);
  check.error(*result, result->shown, "the path of a number in summary.json of a static analysis",
              nearest_result(result->text));
  return false;
}

void check_condition(Checker& check, const FieldValue& condition) {
  const FieldValue* result = condition.find("result");
  if (!check_result(check, result)) return;
  std::vector<const FieldValue*> goals;
  for (const char* relation : {"equals", "at_most", "at_least"}) {
    if (const FieldValue* goal = condition.find(relation)) goals.push_back(goal);
  }
  if (goals.size() != 1) {
    check.error(condition, goals.empty() ? "no value for the result" : "several values for the result",
                "one of equals, at_most or at_least");
    return;
  }
  check_value(check, goals.front(), *result_row(result->text));
}

}  // namespace

void check_seek(Checker& check) {
  const FieldValue* seek = check.root().find("seek");
  if (seek == nullptr) return;
  for (const FieldValue* variable : groups(*seek, "vary")) check_variable(check, *variable);
  for (const FieldValue* condition : groups(*seek, "until")) check_condition(check, *condition);
  if (const FieldValue* minimise = seek->find("minimise")) {
    check_result(check, minimise);
  } else if (!seek->mentions("until")) {
    check.missing(*seek, "until", "a condition on a result", "or give a result to minimise");
  }
}

}  // namespace overbend
