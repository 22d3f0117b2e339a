#include <algorithm>
#include <utility>

#include "base/text.h"
#include "base/units.h"
#include "model/description/description_words.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

bool cable_from_winch(OperationType type) {
  using enum OperationType;
  return type == abandonment || type == recovery || type == lay_down;
}

/// The key of a stage that says how far the operation has gone.
const char* progress_key(OperationType type) {
  using enum OperationType;
  if (type == OperationType::ballast) return "ballast";
  if (type == start_up || drags_along_bed(type)) return "pipe_out";
  if (type == move) return "ahead";
  return type == passage ? "passed" : "cable_out";
}

void need_group(Checker& check, const FieldValue& operation, const std::string& key, OperationType type) {
  if (is_given(operation, key) || operation.mentions(key)) return;
  check.missing(operation, key, "a group of keys", std::string(word_of(type)) + " needs it");
}

/// Both weights of a cable or a head.
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
    check.error(*friction, "friction of the cable", "none: only in shore_pull and hold_back it is dragged");
  }
  if (type == start_up && !cable->mentions("length")) {
    check.missing(*cable, "length", "a length with its unit", "from the head to the anchor");
  } else if (cable_from_winch(type) && length != nullptr) {
    check.error(*length, "a length of the cable", "none: cable_out of each stage says how much is out");
  }
}

void check_anchor_depth(Checker& check, const FieldValue& operation) {
  const FieldValue* depth = operation.find("anchor.depth");
  const std::optional<double> bed = level_bed(check.root());
  if (depth != nullptr && bed && depth->number > *bed) {
    check.error(*depth, depth->shown, "at most the depth of the seabed, " + format_quantity(*bed, "m", "m"));
  }
}

/// The keys of the place of the winch that this type has, each of them.
void check_winch(Checker& check, const FieldValue& operation, OperationType type) {
  const FieldValue* winch = operation.find("winch");
  if (winch == nullptr || !winch->given) return;
  const bool away = drags_along_bed(type);
  for (const auto& [key, far] : {std::pair{"x", false}, {"z", false}, {"distance", true}, {"depth", true}}) {
    const FieldValue* value = winch->find(key);
    if (far == away && !winch->mentions(key)) {
      check.missing(*winch, key, "a length with its unit", std::string("operation.winch of ") + word_of(type));
    } else if (far != away && value != nullptr && value->given) {
      check.error(*value, std::string(key) + " of a winch " + (far ? "at a distance" : "on the vessel"),
                  std::string(away ? "distance and depth" : "x and z") + " in " + word_of(type));
    }
  }
  const FieldValue* depth = winch->find("depth");
  const std::optional<double> bed = level_bed(check.root());
  if (away && depth != nullptr && bed && depth->number > *bed) {
    check.error(*depth, depth->shown, "at most the depth of the seabed, " + format_quantity(*bed, "m", "m"));
  }
}

/// The pipe ends before the winch, and the cable of the winch reaches its head.
void check_pipe_out(Checker& check, const FieldValue& operation, const FieldValue* out) {
  const auto distance = operation.get_number("winch.distance"), head = operation.get_number("head.length");
  if (out == nullptr || !out->given || !distance || !head) return;
  const double way = *distance - check.root().get_number("tensioner.x").value_or(0.0);
  const double left = way - out->number - *head;
  if (left <= 0.0) {
    check.error(*out, "pipe with its head as far as " + format_quantity(out->number + *head, "m", "m"),
                "less than the distance from tensioner to winch, " + format_quantity(way, "m", "m"),
                "the pipe has passed the winch");
    return;
  }
  const FieldValue* cable = operation.find("cable.length");
  if (cable == nullptr || !cable->given || cable->number >= left) return;
  check.error(*cable, "a cable of " + cable->shown,
              "at least the " + format_quantity(left, "m", "m") + " from the head to the winch",
              "it does not reach the pipe at " + out->path + " of " + out->shown);
}

/// A stage or a list of tensions beside an anchor whose place decides the tension.
void check_tension_is_free(Checker& check, const FieldValue& operation, const FieldValue* tension) {
  if (tension == nullptr || !tension->given || operation.find("anchor.distance") == nullptr) return;
  check.error(*tension, "a tension beside anchor.distance", "one of them", "the tension follows from the distance");
}

void check_breaking_load(Checker& check, const FieldValue& operation, const FieldValue* tension) {
  const FieldValue* breaking = operation.find("cable.breaking_load");
  if (tension == nullptr || breaking == nullptr || tension->number < breaking->number) return;
  check.error(*tension, tension->shown, "less than the cable's breaking load, " + breaking->shown);
}

/// Whether the tensioner's tension stands in for that of a stage; without a tensioner that is complained of elsewhere.
bool tensioner_pulls(const FieldValue& root) {
  const FieldValue* tensioner = root.find("tensioner");
  return tensioner == nullptr || tensioner->mentions("tension");
}

void check_stage(Checker& check, const FieldValue& operation, OperationType type, const FieldValue& stage) {
  const std::string key = progress_key(type);
  const bool emptied = type == OperationType::ballast && stage.mentions("weight");
  if (!stage.mentions(key) && type == OperationType::ballast && !emptied) {
    check.missing(stage, key, "a fraction or a weight", "what is in the tank at this stage");
  } else if (!stage.mentions(key) && !emptied) {
    check.missing(stage, key, "a length with its unit", "how far the line has gone at this stage");
  }
  const FieldValue *tension = stage.find("tension"), *bottom = stage.find("bottom_tension");
  if (tension != nullptr && bottom != nullptr) {
    check.error(*bottom, "a tension and a bottom_tension", "one of them", "the other follows");
  }
  check_tension_is_free(check, operation, tension);
  check_tension_is_free(check, operation, bottom);
  if (cable_from_winch(type)) check_breaking_load(check, operation, tension);
  if (drags_along_bed(type)) check_pipe_out(check, operation, stage.find("pipe_out"));
  const bool given = stage.mentions("tension") || stage.mentions("bottom_tension") || tensioner_pulls(check.root());
  if (!given && operation.find("anchor.distance") == nullptr) {
    check.missing(stage, "tension", "a force with its unit", "or give tensioner.tension for all stages");
  }
}

/// Where a line of given length ends, pipe has to lie: behind the head, however much cable is out.
void check_line_length(Checker& check, const FieldValue& operation) {
  const FieldValue *length = check.root().find("pipe.length"), *stages = operation.find("stages");
  if (length == nullptr || stages == nullptr) return;
  const FieldValue* longest = nullptr;
  const auto take = [&](const FieldValue* cable) {
    if (cable != nullptr && (longest == nullptr || cable->number > longest->number)) longest = cable;
  };
  if (stages->kind == FieldValue::Kind::map) {
    for (const char* end : {"from", "to"}) take(stages->find(end));
  } else {
    for (const FieldValue& stage : stages->children) take(stage.find("cable_out"));
  }
  const double head = operation.get_number("head.length").value_or(0.0);
  if (longest == nullptr || longest->number + head < length->number) return;
  check.error(*length, "a line of " + length->shown,
              "more than the longest cable with the head, " + format_quantity(longest->number + head, "m", "m"),
              "see " + longest->path + "; or omit pipe.length, and the line is made long enough");
}

/// The stages of a recovery stand in the file as those of the abandonment.
void check_order(Checker& check, OperationType type, const FieldValue& stages) {
  using enum OperationType;
  if (type != recovery || stages.children.size() < 2) return;
  const auto first = stages.children.front().get_number("cable_out");
  const auto last = stages.children.back().get_number("cable_out");
  if (first && last && *first > *last) {
    check.warn(stages,
               "the stages of a recovery are done in reverse order: from the last listed, with the shortest "
               "cable here, to the first; list them as those of the abandonment");
  }
}

/// A key of generated stages that only one way to choose the tension has.
void only_with(Checker& check, const FieldValue& program, const char* key, StageTension wanted, StageTension tension) {
  const FieldValue* value = program.find(key);
  if (value == nullptr || !value->given || tension == wanted) return;
  check.error(*value, std::string("a key of tension: ") + word_of(wanted),
              std::string("none with tension: ") + word_of(tension));
}

void check_program(Checker& check, const FieldValue& operation, OperationType type, const FieldValue& program) {
  using enum OperationType;
  const FieldValue *from = program.find("from"), *to = program.find("to");
  if (from != nullptr && to != nullptr && from->number == to->number) {
    check.error(*to, to->shown, "another length than from, " + from->shown);
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
    check.missing(program, "bottom_tension", "a force with its unit", "tension: bottom needs it");
  }
  check_tension_is_free(check, operation, program.find("tension"));
  if (cable_from_winch(type)) {
    for (const FieldValue& value : Checker::items(program, "tension")) check_breaking_load(check, operation, &value);
  }
  const FieldValue *least = program.find("tension_from"), *most = program.find("tension_to");
  if (least != nullptr && most != nullptr && least->number >= most->number) {
    check.error(*most, most->shown, "more than tension_from, " + least->shown);
  }
  const FieldValue* force = program.find("tension");
  const bool one_force = force != nullptr && force->kind == FieldValue::Kind::number;
  if (one_force && cable_from_winch(type)) check_breaking_load(check, operation, force);
  const bool held = tension == StageTension::hold && !one_force && Checker::items(program, "tension").empty();
  if (held && operation.find("anchor.distance") == nullptr && !tensioner_pulls(check.root())) {
    check.missing(program, "tension", "a list of forces, bottom or seek", "or give tensioner.tension for all stages");
  }
}

/// The tank that is filled or emptied.
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
    check.missing(operation, "tank", "the name of a tank of the stinger", "its ballast changes");
  }
}

void check_stages(Checker& check, const FieldValue& operation, OperationType type) {
  const FieldValue* stages = operation.find("stages");
  if (!operation.mentions("stages") || (stages != nullptr && !stages->given)) {
    check.missing(operation, "stages", "a list of stages, or from, to and steps",
                  std::string(word_of(type)) + " needs it");
  } else if (stages != nullptr && stages->kind == FieldValue::Kind::map && type == OperationType::ballast) {
    check.error(*stages, "stages at even steps", "a list of stages", "such are made of lengths of the line only");
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
    check.missing(check.root(), "pipe", "a group of keys", "the operation is one of the line");
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
