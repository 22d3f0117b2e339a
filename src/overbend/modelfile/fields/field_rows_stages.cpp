#include "model/description/description_enum_names.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

using Operation = OperationDescription;

/// Stage whose keys are being bound: of a moored vessel or of the line, according to the type of the operation. Keys of
/// the other kind (an error, which the checks report) go to a spare.
struct StageTarget {
  MooredStageDescription* moored_stage = nullptr;
  LayStageDescription* lay_stage = nullptr;
  MooredStageDescription spare_moored = {};
  LayStageDescription spare_lay = {};

  MooredStageDescription& moored() { return moored_stage != nullptr ? *moored_stage : spare_moored; }
  LayStageDescription& lay() { return lay_stage != nullptr ? *lay_stage : spare_lay; }
};

Operation& start_stages(Operation& operation, const FieldValue&) {
  operation.stages.clear();
  operation.lay.stages.clear();
  return operation;
}

StageTarget add_stage(Operation& operation, const FieldValue&) {
  StageTarget stage;
  if (is_lay_operation(operation.type)) {
    stage.lay_stage = &operation.lay.stages.emplace_back();
  } else {
    stage.moored_stage = &operation.stages.emplace_back();
    stage.moored_stage->name = "stage " + std::to_string(operation.stages.size());
  }
  return stage;
}

Member names_stage() {
  return taken_by<StageTarget>(
      [](StageTarget& stage, const FieldValue& name) { stage.moored().name = stage.lay().name = name.text; });
}

/// Number of a stage of the line.
Field lay_number(const std::string& key, std::optional<double> LayStageDescription::*member, const std::string& text,
                 const Shown& shown, const Range& range, const std::string& omitted) {
  const Member take = taken_by<StageTarget>(
      [member](StageTarget& stage, const FieldValue& value) { stage.lay().*member = value.number; });
  return otherwise(quantity_row("operation.stages[]." + key, take, text, shown, range), omitted);
}

Member adds_line_value(std::vector<LineValue> LayStageDescription::*list) {
  return taken_by<StageTarget>([list](StageTarget& stage, const FieldValue& value) {
    (stage.lay().*list).push_back({value.key, value.number});
  });
}

JoinDescription& join_row(StageTarget& stage, const FieldValue& group) {
  JoinDescription& join = stage.lay().join.emplace();
  const FieldValue* lines = group.find("lines");
  if (lines != nullptr && lines->children.size() == 2) {
    join.first = lines->children[0].text;
    join.second = lines->children[1].text;
  }
  return join;
}

/// Keys of a lift stage: lines, vessel and welds.
std::vector<Field> lift_stage(const std::string& s) {
  const auto vessel = [](StageTarget& stage, const FieldValue&) -> VesselOffset& {
    return stage.lay().vessel.emplace();
  };
  const auto body = [](StageTarget& stage, const FieldValue& value) -> VesselOffset& {
    return stage.lay().bodies.emplace_back(BodyOffset{value.key, {}}).offset;
  };
  return {
      otherwise(group_row(s + ".lengths", {}, "lift: unstressed lengths of lines, by their names."),
                "as in the stage before"),
      quantity_row(s + ".lengths.*", adds_line_value(&LayStageDescription::lengths), "Length of that line.", kLength,
                   kPositive),
      otherwise(group_row(s + ".tensions", {},
                          "lift: tensions at the upper ends of lines, by their names, in place of their lengths. The "
                          "resulting length is kept until a stage gives another."),
                "as in the stage before"),
      quantity_row(s + ".tensions.*", adds_line_value(&LayStageDescription::tensions), "Tension of that line.", kForce,
                   kPositive),
      otherwise(group_row(s + ".vessel", opened_by<StageTarget>(vessel),
                          "lift: offset of the vessel from its position as drawn, along its axes there; not "
                          "accumulated from stage to stage."),
                "as in the stage before"),
      quantity_row(s + ".vessel.x", with_default(fills(&VesselOffset::x), 0.0), "Forward.", kLength),
      quantity_row(s + ".vessel.y", with_default(fills(&VesselOffset::y), 0.0), "To port.", kLength),
      quantity_row(s + ".vessel.heading", with_default(fills(&VesselOffset::heading), 0.0), "Clockwise from above.",
                   kAngle, azimuth()),
      otherwise(group_row(s + ".bodies", {},
                          "lift: offsets of bodies other than the vessel, by their names, each from its position as "
                          "drawn along its axes there."),
                "as in the stage before"),
      group_row(s + ".bodies.*", opened_by<StageTarget>(body), "Offset of that body."),
      quantity_row(s + ".bodies.*.x", with_default(fills(&VesselOffset::x), 0.0), "Forward.", kLength),
      quantity_row(s + ".bodies.*.y", with_default(fills(&VesselOffset::y), 0.0), "To port.", kLength),
      quantity_row(s + ".bodies.*.heading", with_default(fills(&VesselOffset::heading), 0.0), "Clockwise from above.",
                   kAngle, azimuth()),
      otherwise(group_row(s + ".join", opened_by<StageTarget>(join_row),
                          "lift: the first ends of two lines become one node, from this stage on."),
                "no new weld"),
      required(list_row(s + ".join.lines", {}, "Names of the two lines.", "")),
      row_of_kind(FieldKind::text, s + ".join.lines[]", read_elsewhere(), "Name of a line."),
      quantity_row(s + ".join.kink", defaults(&JoinDescription::kink),
                   "Change of direction at the weld from the first line to the second, sagging positive.", kAngle,
                   {.low = -1.6, .high = 1.6}),
  };
}

std::vector<Field> listed() {
  using Lay = LayStageDescription;
  using Moored = MooredStageDescription;
  const std::string s = "operation.stages[]";
  const auto parted = [](StageTarget& stage, const FieldValue&) -> std::vector<std::string>& {
    return stage.moored().parted;
  };
  const auto loads = [](StageTarget& stage, const FieldValue&) -> decltype(Moored::loads)& {
    return stage.moored().loads;
  };
  std::vector<Field> rows = {
      list_row("operation.stages", opened_by<Operation>(start_stages),
               "moored: load cases, each from the vessel as drawn. Operations on the line: progress of the line and "
               "its tension; those of recovery are run in reverse order.",
               "the model as it is; required by operations on the line"),
      group_row(s, opened_by<Operation>(add_stage), "One stage."),
      otherwise(row_of_kind(FieldKind::text, s + ".name", names_stage(), "Name in the results."), "stage 1, 2, ..."),
      list_row(s + ".parted", opened_by<StageTarget>(parted), "moored: names of mooring lines that have failed.",
               "none"),
      row_of_kind(FieldKind::text, s + ".parted[]", appends_value<std::string>(), "A name under moorings.lines."),
      list_row(s + ".loads", opened_by<StageTarget>(loads), "moored: loads on the vessel in addition to vessel.loads.",
               "none")};
  append(rows, vessel_load_rows(s + ".loads"));
  append(rows, lift_stage(s));
  append(rows, {lay_number("cable_out", &Lay::cable_out,
                           "abandonment, recovery and lay_down: unstressed length of the cable from winch to head.",
                           kLength, kPositive, "not used by other types"),
                lay_number(
                    "pipe_out", &Lay::pipe_out,
                    "start_up, shore_pull and hold_back: unstressed length of the pipe from the tensioner to the head.",
                    kLength, kPositive, "not used by other types"),
                lay_number("passed", &Lay::passed,
                           "passage: unstressed length from the tensioner to the middle of the structure.", kLength,
                           kNotNegative, "not used by other types"),
                lay_number("ahead", &Lay::ahead, "move: length of pipe that has left the vessel as it moved ahead.",
                           kLength, kNotNegative, "not used by other types"),
                lay_number("weight", &Lay::tank_weight, "ballast: weight of the empty tank.", kForce, kNotNegative,
                           "that of the tank"),
                otherwise(row_of_kind(FieldKind::number, s + ".ballast",
                                      taken_by<StageTarget>([](StageTarget& stage, const FieldValue& value) {
                                        stage.lay().tank_ballast = value.number;
                                      }),
                                      "ballast: fraction of the tank that is flooded.", {.low = 0.0, .high = 1.0}),
                          "that of the tank"),
                lay_number("tension", &Lay::tension, "Effective tension at the winch or tensioner.", kForce, kPositive,
                           "tensioner.tension"),
                lay_number("bottom_tension", &Lay::bottom_tension,
                           "Alternative to tension: horizontal tension at touchdown.", kForce, kPositive, "not used")});
  return rows;
}

/// Limits for a tension found by search.
std::vector<Field> limits() {
  using Limits = StageLimits;
  const std::string p = "operation.stages.limits";
  const auto limit = [&](const std::string& key, std::optional<double> Limits::*member, const std::string& text,
                         const Shown& shown, const Range& range) {
    return otherwise(quantity_row(p + "." + key, fills(member), text, shown, range), "no limit");
  };
  return {group_row(p, enters(&StageProgram::limits), "tension: seek: limits that every stage must satisfy."),
          limit("sagbend_strain", &Limits::sagbend_strain, "Maximum strain in the sagbend.", {"1", "%"},
                {.low = 0.0, .high = 0.1, .low_open = true}),
          limit("sagbend_stress", &Limits::sagbend_stress, "Maximum von Mises stress in the sagbend.", {"N/m^2", "MPa"},
                kPositive),
          limit("tip_clearance", &Limits::tip_clearance, "Minimum clearance over the last roller of the stinger.",
                kLength, kNotNegative),
          limit("roller_load", &Limits::roller_load, "Maximum reaction of a roller.", kForce, kPositive),
          row_of_kind(FieldKind::number, p + ".utilisation", defaults(&Limits::utilisation),
                      "Maximum utilisation of the code checks and of the cable's breaking load.",
                      {.low = 0.0, .high = 10.0, .low_open = true})};
}

void hold_values(StageProgram& program, const FieldValue& value) {
  program.tension = StageTension::hold;
  program.values.push_back(value.number);
}

/// Text, or one force for all stages.
Field program_tension(const std::string& path) {
  const auto take = [](StageProgram& program, const FieldValue& value) {
    if (value.kind == FieldValue::Kind::number) {
      program.values = {value.number};
    } else {
      program.tension = *from_enum_name<StageTension>(value.text);
    }
  };
  Field row = row_of_kind(
      FieldKind::choice, path, with_default(taken_by<StageProgram>(take), enum_name(StageTension::hold)),
      "hold: tensioner.tension; bottom: such that bottom_tension is the horizontal tension at touchdown; seek: the "
      "minimum that satisfies the limits; or the force at the winch or tensioner, or a list of forces.",
      kPositive);
  row.unit = kForce.unit;
  row.show = kForce.show;
  for (const auto& word : kEnumNames<StageTension>) row.choices.emplace_back(word.word);
  return row;
}

std::vector<Field> generated() {
  using Program = StageProgram;
  const std::string p = "operation.stages";
  const auto open = [](Operation& operation, const FieldValue&) -> Program& { return operation.lay.program.emplace(); };
  const auto itself = [](Program& program, const FieldValue&) -> Program& {
    program.values.clear();
    return program;
  };
  const auto bound = [&](const std::string& key, std::optional<double> Program::*member, const std::string& text,
                         const std::string& omitted) {
    return otherwise(quantity_row(p + "." + key, fills(member), text, kForce, kPositive), omitted);
  };
  Field values = list_row(p + ".tension", opened_by<Program>(itself),
                          "Forces evenly spaced from the first stage to the last, linear between them.", "hold");
  values.min_items = 1;
  std::vector<Field> rows = {
      group_row(p, opened_by<Operation>(open),
                "Evenly spaced stages of an operation on the line, in steps of cable_out, pipe_out, ahead or passed."),
      required(quantity_row(p + ".from", fills(&Program::from),
                            "cable_out, pipe_out, ahead or passed of the first stage.", kLength, kNotNegative)),
      required(quantity_row(p + ".to", fills(&Program::to), "cable_out, pipe_out, ahead or passed of the last stage.",
                            kLength, kNotNegative)),
      row_of_kind(FieldKind::integer, p + ".steps", defaults(&Program::steps),
                  "Number of steps between them; there is one more stage.", {.low = 1.0, .high = 1000.0}),
      program_tension(p + ".tension"),
      values,
      quantity_row(p + ".tension[]", taken_by<Program>(hold_values), "Effective tension at the winch or tensioner.",
                   kForce, kPositive),
      bound("bottom_tension", &Program::bottom_tension, "tension: bottom: horizontal tension at touchdown.",
            "required by tension: bottom"),
      bound("tension_from", &Program::tension_from, "tension: seek: minimum tension allowed.", "chosen by the program"),
      bound("tension_to", &Program::tension_to, "tension: seek: maximum tension allowed.", "chosen by the program")};
  append(rows, limits());
  return rows;
}

}  // namespace

std::vector<Field> operation_stages() {
  std::vector<Field> rows = listed();
  append(rows, generated());
  return rows;
}

}  // namespace overbend::field_rows
