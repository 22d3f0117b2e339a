#include <algorithm>
#include <utility>

#include "base/text.h"
#include "base/units.h"
#include "model/description/description_enum_names.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

bool cable_from_winch(OperationType type) {
  using enum OperationType;
  return type == abandonment || type == recovery || type == lay_down;
}

/// Returns the key of a stage that measures the progress of the operation.
const char* progress_key(OperationType type) {
  using enum OperationType;
  if (type == OperationType::ballast) return "ballast";
  if (type == start_up || drags_along_bed(type)) return "pipe_out";
  if (type == move) return "ahead";
  return type == passage ? "passed" : "cable_out";
}

void need_group(Checker& check, const FieldValue& operation, const std::string& key, OperationType type) {
  if (is_given(operation, key) || operation.mentions(key)) return;
  check.missing(operation, key, "a group of keys", std::string(enum_name(type)) + " requires it");
}

/// Checks both weights of a cable or a head.
void check_weights(Checker& check, const FieldValue& body, const char* what) {
  const FieldValue *air = body.find("weight_in_air"), *submerged = body.find("weight_submerged");
  if (air == nullptr || submerged == nullptr) return;
  if (submerged->number >= air->number) {
    check.error(*submerged, submerged->shown, "less than its weight in air, " + air->shown);
  } else if (submerged->number <= 0.0) {
    check.warn(*submerged, std::string(what) + " of " + submerged->shown + " under water floats");
  }
}

void check_cable(Checker& check, const FieldValue& operation, OperationType type) {
  using enum OperationType;
  const FieldValue* cable = operation.find("cable");
  if (cable == nullptr) return;
  check_weights(check, *cable, "a cable");
  const FieldValue *length = cable->find("length"), *friction = cable->find("friction");
  if (friction != nullptr && friction->given && !drags_along_bed(type)) {
    check.error(*friction, "friction of the cable", "none: it is used in shore_pull and hold_back only");
  }
  if (type == start_up && !cable->mentions("length")) {
    check.missing(*cable, "length", "a length with its unit", "from the head to the anchor");
  } else if (cable_from_winch(type) && length != nullptr) {
    check.error(*length, "a length of the cable", "none: cable_out of each stage gives the length");
  }
}

void check_anchor_depth(Checker& check, const FieldValue& operation) {
  const FieldValue* depth = operation.find("anchor.depth");
  const std::optional<double> bed = level_bed(check.root());
  if (depth != nullptr && bed && depth->number > *bed) {
    check.error(*depth, depth->shown, "at most the depth of the seabed, " + format_quantity(*bed, "m", "m"));
  }
}

/// Checks that the winch has exactly the position keys of its type.
void check_winch(Checker& check, const FieldValue& operation, OperationType type) {
  const FieldValue* winch = operation.find("winch");
  if (winch == nullptr || !winch->given) return;
  const bool away = drags_along_bed(type);
  for (const auto& [key, far] : {std::pair{"x", false}, {"z", false}, {"distance", true}, {"depth", true}}) {
    const FieldValue* value = winch->find(key);
    if (far == away && !winch->mentions(key)) {
      check.missing(*winch, key, "a length with its unit", std::string("operation.winch of ") + enum_name(type));
    } else if (far != away && value != nullptr && value->given) {
      check.error(*value, std::string(key) + " of a winch " + (far ? "at a distance" : "on the vessel"),
                  std::string(away ? "distance and depth" : "x and z") + " in " + enum_name(type));
    }
  }
  const FieldValue* depth = winch->find("depth");
  const std::optional<double> bed = level_bed(check.root());
  if (away && depth != nullptr && bed && depth->number > *bed) {
    check.error(*depth, depth->shown, "at most the depth of the seabed, " + format_quantity(*bed, "m", "m"));
  }
}

/// Checks that the pipe ends before the winch and that the cable reaches its head.
void check_pipe_out(Checker& check, const FieldValue& operation, const FieldValue* out) {
  const auto distance = operation.get_number("winch.distance"), head = operation.get_number("head.length");
  if (out == nullptr || !out->given || !distance || !head) return;
  const double distance_to_winch = *distance - check.root().get_number("tensioner.x").value_or(0.0);
  const double left = distance_to_winch - out->number - *head;
  if (left <= 0.0) {
    check.error(*out, "a pipe whose head is at " + format_quantity(out->number + *head, "m", "m"),
                "less than the distance from tensioner to winch, " + format_quantity(distance_to_winch, "m", "m"),
                "the pipe has passed the winch");
    return;
  }
  const FieldValue* cable = operation.find("cable.length");
  if (cable == nullptr || !cable->given || cable->number >= left) return;
  check.error(*cable, "a cable of " + cable->shown,
              "at least the " + format_quantity(left, "m", "m") + " from the head to the winch",
              "it does not reach the pipe at " + out->path + " of " + out->shown);
}

/// Checks that no tension is given together with an anchor position that determines it.
void check_tension_is_free(Checker& check, const FieldValue& operation, const FieldValue* tension) {
  if (tension == nullptr || !tension->given || operation.find("anchor.distance") == nullptr) return;
  check.error(*tension, "a tension and anchor.distance", "one of them", "the tension follows from the distance");
}

void check_breaking_load(Checker& check, const FieldValue& operation, const FieldValue* tension) {
  const FieldValue* breaking = operation.find("cable.breaking_load");
  if (tension == nullptr || breaking == nullptr || tension->number < breaking->number) return;
  check.error(*tension, tension->shown, "less than the cable's breaking load, " + breaking->shown);
}

/// Returns true if the tensioner's tension is the default of a stage, or if the missing tensioner is reported
/// elsewhere.
bool tensioner_pulls(const FieldValue& root) {
  const FieldValue* tensioner = root.find("tensioner");
  return tensioner == nullptr || tensioner->mentions("tension");
}

void check_stage(Checker& check, const FieldValue& operation, OperationType type, const FieldValue& stage) {
  const std::string key = progress_key(type);
  const bool emptied = type == OperationType::ballast && stage.mentions("weight");
  if (!stage.mentions(key) && type == OperationType::ballast && !emptied) {
    check.missing(stage, key, "a fraction or a weight", "the contents of the tank at this stage");
  } else if (!stage.mentions(key) && !emptied) {
    check.missing(stage, key, "a length with its unit", "the progress of the line at this stage");
  }
  const FieldValue *tension = stage.find("tension"), *bottom = stage.find("bottom_tension");
  if (tension != nullptr && bottom != nullptr) {
    check.error(*bottom, "a tension and a bottom_tension", "one of them", "the other follows from it");
  }
  check_tension_is_free(check, operation, tension);
  check_tension_is_free(check, operation, bottom);
  if (cable_from_winch(type)) check_breaking_load(check, operation, tension);
  if (drags_along_bed(type)) check_pipe_out(check, operation, stage.find("pipe_out"));
  const bool has_tension =
      stage.mentions("tension") || stage.mentions("bottom_tension") || tensioner_pulls(check.root());
  if (!has_tension && operation.find("anchor.distance") == nullptr) {
    check.missing(stage, "tension", "a force with its unit", "or give tensioner.tension for all stages");
  }
}

/// Checks that a line of given length ends in pipe, behind the head, for every cable length.
void check_line_length(Checker& check, const FieldValue& operation) {
  const FieldValue *length = check.root().find("pipe.length"), *stages = operation.find("stages");
  if (length == nullptr || stages == nullptr) return;
  const FieldValue* max_cable = nullptr;
  const auto take = [&](const FieldValue* cable) {
    if (cable != nullptr && (max_cable == nullptr || cable->number > max_cable->number)) max_cable = cable;
  };
  if (stages->kind == FieldValue::Kind::map) {
    for (const char* end : {"from", "to"}) take(stages->find(end));
  } else {
    for (const FieldValue& stage : stages->children) take(stage.find("cable_out"));
  }
  const double head = operation.get_number("head.length").value_or(0.0);
  if (max_cable == nullptr || max_cable->number + head < length->number) return;
  check.error(*length, "a line of " + length->shown,
              "more than the longest cable with the head, " + format_quantity(max_cable->number + head, "m", "m"),
              "see " + max_cable->path + "; or omit pipe.length, and the program chooses a sufficient length");
}

/// Warns if the stages of a recovery are not listed in the order of the abandonment.
void check_order(Checker& check, OperationType type, const FieldValue& stages) {
  using enum OperationType;
  if (type != recovery || stages.children.size() < 2) return;
  const auto first = stages.children.front().get_number("cable_out");
  const auto last = stages.children.back().get_number("cable_out");
  if (first && last && *first > *last) {
    check.warn(stages,
               "the stages of a recovery are run in reverse order, from the last listed, with the shortest cable here, "
               "to the first; list them as for the abandonment");
  }
}

/// Checks a key of generated stages that is valid for one way to choose the tension only.
void only_with(Checker& check, const FieldValue& program, const char* key, StageTension wanted, StageTension tension) {
  const FieldValue* value = program.find(key);
  if (value == nullptr || !value->given || tension == wanted) return;
  check.error(*value, std::string("a key of tension: ") + enum_name(wanted),
              std::string("none with tension: ") + enum_name(tension));
}

void check_program(Checker& check, const FieldValue& operation, OperationType type, const FieldValue& program) {
  using enum OperationType;
  const FieldValue *from = program.find("from"), *to = program.find("to");
  if (from != nullptr && to != nullptr && from->number == to->number) {
    check.error(*to, to->shown, "a length other than from, " + from->shown);
  }
  for (const FieldValue* end : {from, to}) {
    if (end == nullptr || end->number > 0.0 || type == move || type == passage) continue;
    check.error(*end, end->shown, "above 0 m", std::string("it is ") + progress_key(type) + " of a stage");
  }
  if (drags_along_bed(type)) {
    for (const FieldValue* end : {from, to}) check_pipe_out(check, operation, end);
  }
  const StageTension tension = program.get_word<StageTension>("tension").value_or(StageTension::hold);
  only_with(check, program, "bottom_tension", StageTension::bottom, tension);
  for (const char* key : {"tension_from", "tension_to", "limits"}) {
    only_with(check, program, key, StageTension::seek, tension);
  }
  if (tension == StageTension::bottom && !program.mentions("bottom_tension")) {
    check.missing(program, "bottom_tension", "a force with its unit", "tension: bottom requires it");
  }
  check_tension_is_free(check, operation, program.find("tension"));
  if (cable_from_winch(type)) {
    for (const FieldValue& value : Checker::items(program, "tension")) check_breaking_load(check, operation, &value);
  }
  const FieldValue *low = program.find("tension_from"), *high = program.find("tension_to");
  if (low != nullptr && high != nullptr && low->number >= high->number) {
    check.error(*high, high->shown, "more than tension_from, " + low->shown);
  }
  const FieldValue* force = program.find("tension");
  const bool one_force = force != nullptr && force->kind == FieldValue::Kind::number;
  if (one_force && cable_from_winch(type)) check_breaking_load(check, operation, force);
  const bool held = tension == StageTension::hold && !one_force && Checker::items(program, "tension").empty();
  if (held && operation.find("anchor.distance") == nullptr && !tensioner_pulls(check.root())) {
    check.missing(program, "tension", "a list of forces, bottom or seek", "or give tensioner.tension for all stages");
  }
}

/// Checks the tank that is flooded or emptied.
void check_tank(Checker& check, const FieldValue& operation) {
  std::vector<std::string> names;
  for (const FieldValue* section : stinger_sections(check.root())) {
    int number = 0;
    for (const FieldValue& tank : Checker::items(*section, "tanks")) {
      ++number;
      names.push_back(tank.get_text("name").value_or("tank " + std::to_string(number)));
    }
  }
  if (const FieldValue* tank = operation.find("tank"); tank != nullptr && tank->given) {
    check_name(check, *tank, names, "supports.stinger.tanks");
  } else {
    check.missing(operation, "tank", "the name of a tank of the stinger", "the operation changes its ballast");
  }
}

void check_stages(Checker& check, const FieldValue& operation, OperationType type) {
  const FieldValue* stages = operation.find("stages");
  if (!operation.mentions("stages") || (stages != nullptr && !stages->given)) {
    check.missing(operation, "stages", "a list of stages, or from, to and steps",
                  std::string(enum_name(type)) + " requires it");
  } else if (stages != nullptr && stages->kind == FieldValue::Kind::map && type == OperationType::ballast) {
    check.error(*stages, "evenly spaced stages", "a list of stages",
                "stages are generated from lengths of the line only");
  } else if (stages != nullptr && stages->kind == FieldValue::Kind::map) {
    check_program(check, operation, type, *stages);
  } else if (stages != nullptr && stages->children.empty()) {
    check.error(*stages, "an empty list", "at least one stage");
  } else if (stages != nullptr) {
    for (const FieldValue& stage : stages->children) check_stage(check, operation, type, stage);
    check_order(check, type, *stages);
  }
}

}  // namespace

void check_lay_operation(Checker& check, const FieldValue& operation, OperationType type) {
  using enum OperationType;
  if (!check.root().mentions("pipe")) {
    check.missing(check.root(), "pipe", "a group of keys", "the operation acts on the laid line");
  }
  if (cable_from_winch(type) || type == start_up || drags_along_bed(type)) {
    need_group(check, operation, "head", type);
    need_group(check, operation, "cable", type);
  }
  if (type == start_up) need_group(check, operation, "anchor", type);
  if (drags_along_bed(type)) need_group(check, operation, "winch", type);
  if (type == OperationType::ballast) check_tank(check, operation);
  if (const FieldValue* head = operation.find("head")) check_weights(check, *head, "a head");
  check_cable(check, operation, type);
  check_anchor_depth(check, operation);
  check_winch(check, operation, type);
  check_stages(check, operation, type);
  if (cable_from_winch(type)) check_line_length(check, operation);
}

}  // namespace overbend
