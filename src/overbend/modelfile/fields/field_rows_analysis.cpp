#include <numeric>

#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows.h"
#include "modelfile/schema/field_value.h"

namespace overbend::field_rows {
namespace {

constexpr double kMinElementLength = 0.02;  ///< [m] Far below any pipe diameter, where beam theory is meaningless.

/// Lowest, then highest tension; a tensioner with a range controls it unless `mode` states otherwise.
void take_range(TensionerDescription& tensioner, const FieldValue& range) {
  tensioner.range_low = range.children[0].number;
  tensioner.range_high = range.children[1].number;
  tensioner.mode = TensionerMode::controlled;
}

/// Five times the capacity of the largest vessel: a larger value has a wrong unit [N].
constexpr double kMaxTension = 1e8;
constexpr double kMinTimeStep = 1e-6;  ///< A hundredth of the shortest impact on a stiff roller [s].

/// Seeds 1, 2, ... up to the number given.
void count_seeds(DynamicSettings& settings, const FieldValue& count) {
  settings.seeds.resize(static_cast<std::size_t>(count.integer));
  std::iota(settings.seeds.begin(), settings.seeds.end(), std::uint64_t{1});
}

}  // namespace

std::vector<Field> tensioner() {
  return {
      {.path = "tensioner",
       .member = enters(&Description::tensioner),
       .text = "Where and how the pipe is held, in the ramp/stinger frame: origin on the stern shoe, X "
               "astern, Z up.",
       .fallback_text = "required with a pipe"},
      {.path = "tensioner.x",
       .member = fills(&TensionerDescription::x),
       .kind = FieldKind::quantity,
       .text = "The pipe's axis where the tensioner grips it.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = "tensioner.z",
       .member = fills(&TensionerDescription::z),
       .kind = FieldKind::quantity,
       .text = "The pipe's axis where the tensioner grips it.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = "tensioner.incline",
       .member = defaults(&TensionerDescription::incline),
       .kind = FieldKind::quantity,
       .text = "Inclination of the pipe in the tensioner from horizontal, positive downwards astern.",
       .unit = "rad",
       .show = "deg",
       .range = {.low = -90.0 * kDegree, .high = 90.0 * kDegree}},
      {.path = "tensioner.guide",
       .member = defaults(&TensionerDescription::guide),
       .kind = FieldKind::choice,
       .text = "clamped: the machine fixes the direction of the pipe; pinned: the pipe is free to rotate."},
      {.path = "tensioner.tension",
       .member = fills(&TensionerDescription::tension),
       .kind = FieldKind::quantity,
       .text = "Set tension of the pipe at the tensioner; sufficient on its own for statics.",
       .unit = "N",
       .show = "kN",
       .fallback_text = "follows from pipe.length and pipe.anchor",
       .range = {.low = 0.0, .high = kMaxTension, .low_open = true}},
      {.path = "tensioner.range",
       .member = taken_by<TensionerDescription>(take_range),
       .kind = FieldKind::list,
       .text = "Operational range: lowest and highest tension before the tensioner pays out or hauls in.",
       .fallback_text = "none",
       .min_items = 2,
       .max_items = 2},
      {.path = "tensioner.range[]",
       .member = read_elsewhere(),
       .kind = FieldKind::quantity,
       .text = "Lowest, then highest tension.",
       .unit = "N",
       .show = "kN",
       .range = {.low = 0.0}},
      {.path = "tensioner.mode",
       .member = fills(&TensionerDescription::mode),
       .kind = FieldKind::choice,
       .text = "Behaviour in dynamic analysis. controlled: keeps the tension in the range; locked: brake on; constant: "
               "ideal constant tension.",
       .fallback_text = "controlled with a range, otherwise constant, with a warning"},
      {.path = "tensioner.delay",
       .member = defaults(&TensionerDescription::delay),
       .kind = FieldKind::quantity,
       .text = "Time out of range before it moves.",
       .unit = "s",
       .show = "s",
       .range = {.low = 0.0, .high = 3600.0}},
      {.path = "tensioner.velocity",
       .member = defaults(&TensionerDescription::velocity),
       .kind = FieldKind::quantity,
       .text = "Speed of paying out and hauling in.",
       .unit = "m/s",
       .show = "m/s",
       .range = {.low = 0.0, .high = 20.0}},
      {.path = "tensioner.acceleration",
       .member = fills(&TensionerDescription::acceleration),
       .kind = FieldKind::quantity,
       .text = "Acceleration up to that speed.",
       .unit = "m/s^2",
       .show = "m/s^2",
       .fallback_text = "the speed is reached in 0.5 s",
       .range = {.low = 0.0, .low_open = true}},
      {.path = "tensioner.travel",
       .member = fills(&TensionerDescription::travel),
       .kind = FieldKind::quantity,
       .text = "Maximum travel either way from the start.",
       .unit = "m",
       .show = "m",
       .fallback_text = "unlimited",
       .range = {.low = 0.0}},
  };
}

std::vector<Field> analysis() {
  const std::string m = "analysis.mesh", s = "analysis.static", d = "analysis.dynamic";
  const auto element = [&](const char* key, std::optional<double> MeshDescription::*member, const char* text) {
    return Field{.path = m + key,
                 .member = fills(member),
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "m",
                 .show = "m",
                 .fallback_text = "chosen by the program",
                 .range = {.low = kMinElementLength, .high = 1000.0}};
  };
  const auto time = [&](const char* key, const Member& member, const char* text, Range range) {
    return Field{.path = d + key,
                 .member = member,
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "s",
                 .show = "s",
                 .range = range};
  };
  std::vector<Field> rows = {
      {.path = "analysis", .text = "Solver settings; defaults usually suffice."},
      {.path = m, .member = enters(&Description::mesh), .text = "Element lengths."},
      element(".overbend_element", &MeshDescription::overbend_element, "Over the supports."),
      element(".touchdown_element", &MeshDescription::touchdown_element, "Around touchdown."),
      element(".longest_element", &MeshDescription::max_element_length, "Anywhere."),
      {.path = s, .member = enters(&Description::statics), .text = "Statics."},
      {.path = s + ".method",
       .member = defaults(&StaticSettings::method),
       .kind = FieldKind::choice,
       .text = "newton uses dynamic relaxation as a fallback; dynamic_relaxation starts with it."},
      {.path = s + ".history",
       .member = defaults(&StaticSettings::history),
       .kind = FieldKind::choice,
       .text = "For yielding pipe. laying: every section has passed the supports from the tensioner; monotonic: it is "
               "bent directly to its final shape."},
      {.path = s + ".laying",
       .member = defaults(&StaticSettings::laying),
       .kind = FieldKind::choice,
       .text = "Origin of the pipe's position on the seabed. steady: in equilibrium on the line on which it was laid, "
               "so that a current's side load goes to the supports; static: laid straight on the route and then pulled "
               "sideways."},
      {.path = s + ".roller_friction",
       .member = defaults(&StaticSettings::roller_friction),
       .kind = FieldKind::choice,
       .text = "Friction of the rollers on the pipe. none: they turn freely; lay: full friction against the pipe as it "
               "is paid out; haul: as it is hauled in. shore_pull always uses lay, hold_back haul."},
      {.path = s + ".tolerance",
       .member = defaults(&StaticSettings::tolerance),
       .kind = FieldKind::number,
       .text = "Largest unbalanced nodal force divided by the total weight.",
       .range = {.low = 0.0, .high = 1e-3, .low_open = true}},
      {.path = s + ".max_iterations",
       .member = defaults(&StaticSettings::max_iterations),
       .kind = FieldKind::integer,
       .text = "Newton iterations per stage before another method is tried.",
       .range = {.low = 1.0, .high = 1e6}},
      {.path = s + ".mean_drift",
       .member = fills(&StaticSettings::mean_drift),
       .kind = FieldKind::choice,
       .text = "Mean wave drift on a coupled hull in equilibrium. yes: in statics and in the start of a dynamic "
               "analysis; no: in neither, and it builds up with the waves.",
       .fallback_text = "in the equilibrium that a dynamic analysis starts from, not in statics"},
      {.path = d,
       .member = enters(&Description::dynamics),
       .text = "Dynamics.",
       .fallback_text = "no dynamic analysis"},
      time(".duration", fills(&DynamicSettings::duration),
           "Simulated time covered by the statistics, from t = 0 to the first row of output at or after it.",
           {.low = kMinDuration, .high = kMaxDuration}),
      time(".build_up", defaults(&DynamicSettings::build_up),
           "Time before t = 0 over which waves and vessel motion are ramped up; the current acts in full. With 0 s a "
           "prescribed motion jumps at t = 0 from the static position, or starts at full speed: this gives a warning, "
           "and a jump of 0.1 m or more is an error.",
           {.low = 0.0, .high = kMaxDuration}),
      time(".step", fills(&DynamicSettings::step), "Fixed time step.", {.low = kMinTimeStep}),
      time(".max_step", fills(&DynamicSettings::max_step), "Maximum time step of the adaptive scheme.",
           {.low = kMinTimeStep}),
      {.path = d + ".spectral_radius",
       .member = defaults(&DynamicSettings::spectral_radius),
       .kind = FieldKind::number,
       .text = "At infinite frequency: 1 means no numerical damping, 0 removes all high-frequency motion.",
       .range = {.low = 0.0, .high = 1.0}},
      time(".output_step", defaults(&DynamicSettings::output_step), "Time between stored results.",
           {.low = kMinTimeStep}),
      {.path = d + ".impacts",
       .member = defaults(&DynamicSettings::impacts),
       .kind = FieldKind::choice,
       .text =
           "resolved: short steps follow every impact on a roller; captured: steps stay long, an impact ends within "
           "the step that meets it and its peak force is estimated, for screening."},
      {.path = d + ".impact_steps",
       .member = defaults(&DynamicSettings::impact_steps),
       .kind = FieldKind::number,
       .text =
           "Time steps in the undamped contact time of an impact on a roller, up to its peak; half as many after it.",
       .range = {.low = 2.0, .high = 1000.0}},
      {.path = d + ".impact_force",
       .member = fills(&DynamicSettings::impact_force),
       .kind = FieldKind::quantity,
       .text = "Impacts weaker than this (undamped estimate) are neither resolved nor recorded.",
       .unit = "N",
       .show = "kN",
       .fallback_text = "1 kN, or for a slender pipe less: w (EI/w)^(1/3)/40",
       .range = {.low = 0.0, .low_open = true},
       .usual = {.low = 1.0, .high = 1e6}},
      {.path = d + ".tolerance",
       .member = defaults(&DynamicSettings::tolerance),
       .kind = FieldKind::number,
       .text = "Largest unbalanced nodal force divided by the weight of the line.",
       .range = {.low = 0.0, .high = 1e-3, .low_open = true}},
      {.path = d + ".step_error",
       .member = fills(&DynamicSettings::step_error),
       .kind = FieldKind::quantity,
       .text = "Position error of a node per step, which controls the adaptive step size; larger in proportion to the "
               "length of mooring elements longer than 5 m.",
       .unit = "m",
       .show = "mm",
       .fallback_text = "1 mm, or for a slender pipe or a short line less: D/250, L/400000",
       .range = {.low = 0.0, .high = 1.0, .low_open = true}},
      {.path = d + ".seeds",
       .member = taken_by<DynamicSettings>(count_seeds),
       .kind = FieldKind::integer,
       .text = "Number of seeds: 1, 2, ... up to this; or a list of seeds.",
       .fallback_text = "the seed of the waves",
       .range = {.low = 1.0, .high = 10000.0}},
      {.path = d + ".seeds",
       .member = enters(&DynamicSettings::seeds),
       .kind = FieldKind::list,
       .text = "Seeds of the random waves, one realisation each.",
       .min_items = 1,
       .max_items = 10000},
      {.path = d + ".seeds[]",
       .member = appends_value<std::uint64_t>(),
       .kind = FieldKind::integer,
       .text = "One seed.",
       .range = {.low = 0.0, .high = double{kMaxSeed}}},
  };
  for (Field& row : rows) {
    if (row.path == d + ".duration") row.required = true;
    if (row.path == d + ".step") row.fallback_text = "chosen by the program";
    if (row.path == d + ".max_step") row.fallback_text = "125 ms, or a fiftieth of the shortest prescribed period";
  }
  return rows;
}

}  // namespace overbend::field_rows
