#include <algorithm>

#include "base/text.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

/// Key below `operation`, or of a stage, that only some types have.
struct KeyOwners {
  const char* key;
  std::vector<OperationType> types;
};

const std::vector<KeyOwners>& operation_keys() {
  using enum OperationType;
  static const std::vector<KeyOwners> kKeys = {
      {"speed", {pull_ahead}},
      {"acceleration_time", {pull_ahead}},
      {"start", {pull_ahead}},
      {"wait", {pull_ahead}},
      {"shape", {pull_ahead}},
      {"loads", {pull_ahead}},
      {"distance", {pull_ahead, anchor_plan}},
      {"moves", {pull_ahead, anchor_plan}},
      {"line", {anchor_move}},
      {"to", {anchor_move}},
      {"bearing", {anchor_move}},
      {"anchor_distance", {anchor_move}},
      {"handling_tension", {anchor_move}},
      {"working_tension", {anchor_move}},
      {"test_tension", {anchor_move}},
      {"head", {abandonment, recovery, lay_down, start_up, shore_pull, hold_back}},
      {"cable", {abandonment, recovery, lay_down, start_up, shore_pull, hold_back}},
      {"winch", {abandonment, recovery, lay_down, shore_pull, hold_back}},
      {"anchor", {start_up}},
      {"stages",
       {moored, abandonment, recovery, lay_down, start_up, move, passage, ballast, shore_pull, hold_back, lift}},
      {"tank", {ballast}},
  };
  return kKeys;
}

const std::vector<KeyOwners>& stage_keys() {
  using enum OperationType;
  static const std::vector<OperationType> kOnTheLine = {abandonment, recovery, lay_down,   start_up, move,
                                                        passage,     ballast,  shore_pull, hold_back};
  static const std::vector<KeyOwners> kKeys = {
      {"parted", {moored}},
      {"loads", {moored}},
      {"pipe_out", {start_up, shore_pull, hold_back}},
      {"cable_out", {abandonment, recovery, lay_down}},
      {"ahead", {move}},
      {"passed", {passage}},
      {"tension", kOnTheLine},
      {"bottom_tension", kOnTheLine},
      {"weight", {ballast}},
      {"ballast", {ballast}},
      {"lengths", {lift}},
      {"tensions", {lift}},
      {"vessel", {lift}},
      {"join", {lift}},
  };
  return kKeys;
}

/// Reports keys of `group` that belong to other types of operation.
void check_foreign(Checker& check, const FieldValue& group, const std::vector<KeyOwners>& keys, OperationType type) {
  for (const KeyOwners& owners : keys) {
    const FieldValue* value = group.find(owners.key);
    const bool applies = std::find(owners.types.begin(), owners.types.end(), type) != owners.types.end();
    if (value == nullptr || !value->given || applies) continue;
    std::vector<std::string> type_names;
    for (const OperationType owner : owners.types) type_names.emplace_back(enum_name(owner));
    check.error(*value, "a key of " + join_items(type_names, "or"), "none in this type of operation");
  }
}

void check_parted(Checker& check, const std::vector<FieldValue>& lines) {
  const std::vector<std::string> names = line_names(lines);
  for (const FieldValue& stage : Checker::items(check.root(), "operation.stages")) {
    for (const FieldValue& name : Checker::items(stage, "parted")) check_name(check, name, names, "moorings.lines");
  }
}

/// Checks the line of an anchor move, and that its new anchor position is given in one way.
void check_anchor_move(Checker& check, const FieldValue& operation, const std::vector<FieldValue>& lines) {
  if (const FieldValue* line = operation.find("line"); line != nullptr && line->given) {
    check_name(check, *line, line_names(lines), "moorings.lines");
  } else {
    check.missing(operation, "line", "the name of a mooring line", "the line whose anchor is moved");
  }
  const bool to = operation.mentions("to");
  const bool bearing = operation.mentions("bearing"), distance = operation.mentions("anchor_distance");
  if (to && (bearing || distance)) {
    check.error(*operation.find("to"), "the position of the anchor and its direction or distance", "one of them");
  } else if (!to && !bearing) {
    check.missing(operation, "to", "the new position of the anchor", "or bearing and anchor_distance");
  } else if (!to && !distance) {
    check.missing(operation, "anchor_distance", "a length with its unit", "it is used with bearing");
  }
}

/// Checks operations of a moored vessel; a vessel with prescribed motion may move without lines.
void check_moored_operation(Checker& check, const FieldValue& operation, OperationType type) {
  using enum OperationType;
  const std::vector<FieldValue>& lines = Checker::items(check.root(), "moorings.lines");
  if (type == anchor_move) check_anchor_move(check, operation, lines);
  const bool led = type == pull_ahead && check.root().mentions("pipe") && !hull_floats(check.root());
  const bool of_lines = type == anchor_move || type == anchor_plan;
  const bool positioned = !of_lines && is_given(check.root(), "station_keeping");
  if (lines.empty() && !is_given(check.root(), "moorings") && !led && !positioned) {
    check.missing(check.root(), "moorings", "a group of keys", "the operation acts on a moored vessel");
  }
  const FieldValue* stages = operation.find("stages");
  if (type == moored && stages != nullptr && stages->kind == FieldValue::Kind::map && stages->given) {
    check.error(*stages, "evenly spaced stages", "a list of stages",
                "stages are generated for operations on the line only");
  }
  check_parted(check, lines);
}

}  // namespace

void check_operation(Checker& check) {
  using enum OperationType;
  const FieldValue* operation = check.root().find("operation");
  if (operation == nullptr || !operation->given) return;
  check_unique_names(check, Checker::items(*operation, "stages"), "stage");
  const auto type = operation->get_word<OperationType>("type");
  if (!type) return;
  check_foreign(check, *operation, operation_keys(), *type);
  for (const FieldValue& stage : Checker::items(*operation, "stages")) {
    check_foreign(check, stage, stage_keys(), *type);
  }
  if (*type == lift) {
    check_lift(check, *operation);
  } else if (is_lay_operation(*type)) {
    check_lay_operation(check, *operation, *type);
  } else {
    check_moored_operation(check, *operation, *type);
  }
}

}  // namespace overbend
