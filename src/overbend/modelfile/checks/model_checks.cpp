#include "modelfile/checks/model_checks.h"

#include <algorithm>
#include <filesystem>

#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "checks/steel_grades.h"
#include "model/description/description_enum_names.h"
#include "modelfile/binding/binding.h"
#include "modelfile/binding/tolerances.h"
#include "modelfile/checks/fatigue_checks.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/schema/check_helper.h"

namespace overbend {
namespace {

/// Returns a value of a segment, or of the main section if the segment does not give it.
const FieldValue* own_or_line(const FieldValue& section, const FieldValue& pipe, const std::string& key) {
  const FieldValue* own_value = section.find(key);
  return own_value != nullptr ? own_value : pipe.find(key);
}

/// Two values of a section that limit each other; `at` is the value to report. Empty when one is absent or, in a
/// segment, both are those of the main section, where they are checked.
struct SteelPair {
  const FieldValue *a = nullptr, *b = nullptr, *reported = nullptr;
};

SteelPair steel_pair(const FieldValue& section, const FieldValue& pipe, const std::string& a, const std::string& b) {
  const FieldValue *own_a = section.find("steel." + a), *own_b = section.find("steel." + b);
  if (own_a == nullptr && own_b == nullptr) return {};
  return {own_or_line(section, pipe, "steel." + a), own_or_line(section, pipe, "steel." + b),
          own_b != nullptr ? own_b : own_a};
}

void check_steel(Checker& check, const FieldValue& section, const FieldValue& pipe) {
  const auto [diameter, wall, at_wall] = steel_pair(section, pipe, "outside_diameter", "wall_thickness");
  if (diameter != nullptr && wall != nullptr && wall->number >= 0.5 * diameter->number) {
    check.error(*at_wall, "a wall of " + wall->shown,
                "less than the pipe's radius, " + format_quantity(0.5 * diameter->number, "m", "mm"));
  } else if (diameter != nullptr && wall != nullptr) {
    constexpr double kThickest = 4.0, kThinnest = 150.0;
    const double ratio = diameter->number / wall->number;
    if (ratio < kThickest || ratio > kThinnest) {
      check.warn(*at_wall, wall->shown + " gives a diameter over wall thickness of " + format_number(ratio, 3) +
                               "; pipelines have " + format_number(kThickest) + " to " + format_number(kThinnest) +
                               ": are the units right?");
    }
  }
  const auto [yield, strength, at_strength] = steel_pair(section, pipe, "yield_stress", "tensile_strength");
  if (yield != nullptr && strength != nullptr && strength->number < yield->number) {
    check.error(*at_strength, "a tensile strength of " + strength->shown, "at least the yield stress, " + yield->shown);
  }
}

void check_section(Checker& check, const FieldValue& section, const FieldValue& pipe) {
  check_steel(check, section, pipe);
  const FieldValue* joint = section.find("joint");
  if (joint == nullptr) return;
  const FieldValue* length = joint->find("length");
  const FieldValue* bare = joint->find("field_joint");
  if (length != nullptr && bare != nullptr && bare->number >= length->number) {
    check.error(*bare, bare->shown, "less than the pipe joint's length, " + length->shown);
  }
  if (joint->get_number("coated_stiffness").value_or(1.0) > 1.0 &&
      joint->get_number("strain_factor").value_or(1.0) > 1.0) {
    check.warn(*joint,
               "coated_stiffness already includes the strain concentration at the field joints; strain_factor "
               "multiplies the strain again");
  }
  const FieldValue* coatings = own_or_line(section, pipe, "coatings");
  const bool uncoated = coatings == nullptr ? !section.mentions("coatings") : coatings->children.empty();
  if (uncoated) {
    check.warn(*joint, "without coatings there is nothing to replace with infill; the field joint has no effect",
               FindingCode::unused_input);
  }
}

void check_pipe(Checker& check) {
  const FieldValue* pipe = check.root().find("pipe");
  if (pipe == nullptr) return;
  check_section(check, *pipe, *pipe);
  double total = 0.0;
  for (const FieldValue& segment : Checker::items(*pipe, "segments")) {
    check_section(check, segment, *pipe);
    total += segment.get_number("length").value_or(0.0);
  }
  if (const FieldValue* head = check.root().find("operation.head.section"); head != nullptr && head->given) {
    check_section(check, *head, *pipe);
  }
  const FieldValue* length = pipe->find("length");
  if (length != nullptr && total > length->number) {
    check.error(*pipe->find("segments"), "segments of " + format_quantity(total, "m", "m") + " together",
                "at most the line's length, " + length->shown);
  }
}

/// Checks the wall that remains for collapse.
void check_wall_tolerance(Checker& check) {
  const FieldValue* tolerance = check.root().find("checks.wall_tolerance");
  const FieldValue* pipe = check.root().find("pipe");
  if (tolerance == nullptr || pipe == nullptr) return;
  const auto against = [&](const FieldValue& section) {
    const FieldValue* wall = section.find("steel.wall_thickness");
    if (wall == nullptr || tolerance->number < wall->number) return;
    check.error(*tolerance, "a tolerance of " + tolerance->shown, "less than the wall, " + wall->shown);
  };
  against(*pipe);
  for (const FieldValue& segment : Checker::items(*pipe, "segments")) against(segment);
}

void check_tension(Checker& check) {
  const FieldValue* tensioner = check.root().find("tensioner");
  const FieldValue* pipe = check.root().find("pipe");
  if (tensioner == nullptr || pipe == nullptr) return;
  const bool tension = tensioner->mentions("tension");
  const FieldValue* length = pipe->find("length");
  const FieldValue* anchor = pipe->find("anchor");
  if (!tension && !(pipe->mentions("length") && pipe->mentions("anchor"))) {
    check.missing(*tensioner, "tension", "a force with its unit",
                  "or give pipe.length and pipe.anchor, from which the tension follows");
  }
  if (tension && length != nullptr && anchor != nullptr) {
    check.error(*length, "a length, an anchor and a tension",
                "two of the three: a length and a tension, or a length and an anchor",
                "omit pipe.anchor or tensioner.tension");
  }
  if (tension && anchor != nullptr && !pipe->mentions("length")) {
    check.error(*anchor, "an anchor distance and tensioner.tension",
                "pipe.length together with the tension, or pipe.length and pipe.anchor instead of it",
                "with only a tension the program chooses the end of the line");
  }
}

void check_tensioner_range(Checker& check) {
  const FieldValue* tensioner = check.root().find("tensioner");
  if (tensioner == nullptr) return;
  const FieldValue* range = tensioner->find("range");
  if (!tensioner->mentions("range") && tensioner->get_word<TensionerMode>("mode") == TensionerMode::controlled) {
    check.missing(*tensioner, "range", "the lowest and highest tension, such as [240 kN, 260 kN]",
                  "a controlled tensioner needs a range");
  }
  if (range == nullptr || range->children.size() != 2) return;
  const FieldValue& low = range->children[0];
  const FieldValue& high = range->children[1];
  const std::string shown = low.shown + " to " + high.shown;
  if (low.number >= high.number) {
    check.error(*range, shown, "the lower tension first, then the higher");
    return;
  }
  const FieldValue* tension = tensioner->find("tension");
  if (tension != nullptr && (tension->number < low.number || tension->number > high.number)) {
    // Statics uses the given tension, so a sweep of tensions needs no new range; only a governed tensioner would.
    check.warn(*range,
               shown + " does not contain the set tension, " + tension->shown + "; dynamic analysis will require this");
  }
}

/// Checks that a controlled tensioner has a speed.
void check_tensioner_mode(Checker& check) {
  const FieldValue* tensioner = check.root().find("tensioner");
  if (tensioner == nullptr || check.root().find("analysis.dynamic") == nullptr) return;
  const auto mode = tensioner->get_word<TensionerMode>("mode");
  const bool controlled = mode ? *mode == TensionerMode::controlled : tensioner->mentions("range");
  const auto velocity = check.root().get_number("tensioner.velocity");
  if (controlled && velocity.value_or(0.0) <= 0.0) {
    check.warn(*tensioner,
               "a controlled tensioner without velocity never moves: in dynamic analysis it is a locked brake; give "
               "tensioner.velocity",
               FindingCode::tensioner_never_moves);
  }
}

/// Warns of a row of the laying criteria whose grade exceeds that of the pipe, which is unconservative.
void check_grade(Checker& check) {
  const FieldValue* grade = check.root().find("checks.grade");
  const std::optional<LayingLimits> row = grade == nullptr ? std::nullopt : find_grade_limits(grade->text);
  if (!row) return;
  constexpr double kRounded = 2.5e6;  // tolerance of a grade in MPa rounded from ksi
  std::vector<const FieldValue*> yields{check.root().find("pipe.steel.yield_stress")};
  for (const FieldValue& segment : Checker::items(check.root(), "pipe.segments")) {
    yields.push_back(segment.find("steel.yield_stress"));
  }
  for (const FieldValue* yield : yields) {
    if (yield == nullptr || yield->number + kRounded >= row->yield_stress) continue;
    check.warn(*grade, std::string(grade->text) + " is for a yield stress of " +
                           format_number(row->yield_stress / 1e6, 4) + " MPa: pipe of " + yield->shown +
                           " does not withstand its strains");
    return;
  }
}

void check_accepted_findings(Checker& check) {
  std::vector<std::string> serious;
  for (const FindingKind& kind : finding_kinds()) {
    if (kind.severity == FindingSeverity::serious) serious.emplace_back(kind.name);
  }
  for (const FieldValue& accepted : Checker::items(check.root(), "checks.accepted_findings")) {
    if (ranges::find(serious, accepted.text) != serious.end()) continue;
    check.error(accepted, accepted.shown, "the name of a serious finding: " + join_items(serious, "or"));
  }
}

void check_current(Checker& check) {
  const FieldValue* before = nullptr;
  const auto water_depth = check.root().get_number("environment.water_depth");
  for (const FieldValue& point : Checker::items(check.root(), "environment.current")) {
    const FieldValue* depth = point.find("depth");
    if (depth == nullptr) continue;
    if (before != nullptr && depth->number <= before->number) {
      check.error(*depth, depth->shown, "more than the depth before it, " + before->shown,
                  "the current is listed by increasing depth");
    }
    if (water_depth && depth->number > *water_depth * (1.0 + 1e-12)) {
      check.warn(*depth, depth->shown + " is below the seabed at the stern shoe");
    }
    before = depth;
  }
}

void check_vessel(Checker& check) {
  const FieldValue* vessel = check.root().find("vessel");
  if (vessel == nullptr) return;
  const FieldValue* depth = vessel->find("depth");
  const FieldValue* draught = vessel->find("draught");
  if (depth != nullptr && draught != nullptr && draught->number >= depth->number) {
    const FieldValue& value = draught->given ? *draught : *depth;
    check.error(value, "a draught of " + draught->shown, "less than the vessel's depth, " + depth->shown);
  }
  const FieldValue* shoe = vessel->find("stern_shoe.x");
  if (shoe != nullptr && shoe->number > 0.0) {
    check.warn(*shoe, shoe->shown + " is forward of midship; x is negative towards the stern");
  }
}

/// Warns of missing files that only dynamics reads. The readers of depths and hull data, which statics needs, check
/// their own.
void check_files(Checker& check, const std::string& file) {
  const auto warn_if_missing = [&](const FieldValue* value) {
    std::error_code code;
    if (value != nullptr && !std::filesystem::exists(resolved_file(value->text, file), code)) {
      check.warn(*value, "the file " + value->shown + " does not exist; dynamic analysis will require it");
    }
  };
  for (const Field& row : field_table()) {
    const bool needed = row.path.starts_with("vessel.motion.coupled.") || row.path.starts_with("environment.seabed.");
    if (row.file && !needed) warn_if_missing(check.root().find(row.path));
  }
  const FieldValue* waves = check.root().find("environment.waves");
  if (waves == nullptr || waves->kind != FieldValue::Kind::list) return;
  for (const FieldValue& group : waves->children) {
    for (const char* key : {"spectrum_file", "elevation_file"}) warn_if_missing(group.find(key));
  }
}

/// Checks that a model has a valid set of parts: a pipe with its supports, moorings, free lines, or a floating hull.
void check_parts(Checker& check) {
  const FieldValue& root = check.root();
  const auto any = [&](std::initializer_list<const char*> keys) {
    return std::any_of(keys.begin(), keys.end(), [&](const char* key) { return is_given(root, key); });
  };
  const bool floats = is_given(root, "vessel.motion.coupled");
  const bool pipe = any({"pipe", "tensioner", "supports", "rollers"}) || !(any({"moorings", "lines"}) || floats);
  const auto need = [&](const char* key, const char* what) {
    if (!is_given(root, key)) check.missing(root, key, "a group of keys", what);
  };
  if (pipe) {
    need("pipe", "The pipe");
    need("tensioner", "Where and how the pipe is held");
  }
  if (pipe || any({"moorings"})) need("vessel", pipe ? "The lay vessel" : "The moored vessel");
  const FieldValue* vessel = root.find("vessel");
  if (pipe && vessel != nullptr && vessel->given && !vessel->mentions("stern_shoe")) {
    check.missing(*vessel, "stern_shoe", "a group of keys", "Origin of the ramp/stinger frame, in the vessel's frame");
  }
}

void check_dynamics(Checker& check) {
  const FieldValue* dynamic = check.root().find("analysis.dynamic");
  if (dynamic == nullptr) return;
  const FieldValue* step = dynamic->find("step");
  const FieldValue* max_step = dynamic->find("max_step");
  if (step != nullptr && max_step != nullptr) {
    check.error(*max_step, "step and max_step", "one of them", "step is fixed, max_step limits an adaptive one");
  }
}

}  // namespace

void check_model(const FieldValue& root, const std::string& file, Diagnostics& diagnostics) {
  Checker check(root, file, diagnostics);
  std::set<std::string> used_types;
  check_parts(check);
  check_current(check);
  check_grade(check);
  check_accepted_findings(check);
  check_seabed(check);
  check_waves(root, file, diagnostics);
  check_pipe(check);
  check_materials(root, file, diagnostics);
  check_wall_tolerance(check);
  check_tension(check);
  check_tensioner_range(check);
  check_tensioner_mode(check);
  check_vessel(check);
  check_motion(root, file, diagnostics);
  check_bodies(check, file);
  check_supports(root, file, diagnostics);
  check_hull(check, file);
  check_moorings(check, used_types);
  check_operation(check);
  check_free_lines(check, used_types);
  check_line_types(check, used_types);
  check_structures(check);
  check_route(check);
  check_lay_table(check);
  check_dynamics(check);
  check_fatigue(check);
  check_seek(check);
  check_files(check, file);
  check_tolerances(root, file, diagnostics);
}

}  // namespace overbend
