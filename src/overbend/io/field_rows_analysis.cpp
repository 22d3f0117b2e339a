#include "io/field_rows.h"

namespace overbend::field_rows {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

}  // namespace

std::vector<Field> tensioner() {
  return {
      {.path = "tensioner",
       .text = "Where and how the pipe is held, in the ramp/stinger frame: origin on the stern shoe, X "
               "astern, Z up.",
       .required = true},
      {.path = "tensioner.x",
       .kind = FieldKind::quantity,
       .text = "The pipe's axis where the tensioner grips it.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = "tensioner.z",
       .kind = FieldKind::quantity,
       .text = "The pipe's axis where the tensioner grips it.",
       .unit = "m",
       .show = "m",
       .required = true},
      {.path = "tensioner.incline",
       .kind = FieldKind::quantity,
       .text = "Of the pipe in the tensioner from horizontal, positive when it dips astern.",
       .unit = "rad",
       .show = "deg",
       .fallback = "0 deg",
       .range = {.low = -90.0 * kDeg, .high = 90.0 * kDeg}},
      {.path = "tensioner.guide",
       .kind = FieldKind::choice,
       .text = "clamped: the machine holds the pipe's direction; pinned: the pipe turns freely.",
       .fallback = "clamped",
       .choices = {"clamped", "pinned"}},
      {.path = "tensioner.tension",
       .kind = FieldKind::quantity,
       .text = "Wanted tension of the pipe at the tensioner; alone it is enough for statics.",
       .unit = "N",
       .show = "kN",
       .fallback_text = "follows from pipe.length and pipe.anchor",
       .range = {.low = 0.0, .low_open = true}},
      {.path = "tensioner.range",
       .kind = FieldKind::list,
       .text = "Operational range: lowest and highest tension before the tensioner pays out or hauls in.",
       .fallback_text = "none",
       .least = 2,
       .most = 2},
      {.path = "tensioner.range[]",
       .kind = FieldKind::quantity,
       .text = "Lowest, then highest tension.",
       .unit = "N",
       .show = "kN",
       .range = {.low = 0.0}},
      {.path = "tensioner.mode",
       .kind = FieldKind::choice,
       .text = "controlled: works to keep the range; locked: brake on; constant: ideal constant tension.",
       .fallback_text = "controlled with a range, else locked",
       .choices = {"controlled", "locked", "constant"}},
      {.path = "tensioner.delay",
       .kind = FieldKind::quantity,
       .text = "Time out of range before it moves.",
       .unit = "s",
       .show = "s",
       .fallback = "0 s",
       .range = {.low = 0.0, .high = 3600.0}},
      {.path = "tensioner.velocity",
       .kind = FieldKind::quantity,
       .text = "Speed of paying out and hauling in.",
       .unit = "m/s",
       .show = "m/s",
       .fallback = "0 m/s",
       .range = {.low = 0.0, .high = 20.0}},
      {.path = "tensioner.acceleration",
       .kind = FieldKind::quantity,
       .text = "Acceleration up to that speed.",
       .unit = "m/s^2",
       .show = "m/s^2",
       .fallback_text = "at once",
       .range = {.low = 0.0, .low_open = true}},
      {.path = "tensioner.travel",
       .kind = FieldKind::quantity,
       .text = "Largest travel either way from the start.",
       .unit = "m",
       .show = "m",
       .fallback_text = "unlimited",
       .range = {.low = 0.0}},
  };
}

std::vector<Field> analysis() {
  const std::string m = "analysis.mesh", s = "analysis.static", d = "analysis.dynamic";
  const auto element = [&](const std::string& key, const std::string& text) {
    return Field{.path = m + key,
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "m",
                 .show = "m",
                 .fallback_text = "rule of the mesh",
                 .range = {.low = 0.0, .high = 1000.0, .low_open = true}};
  };
  const auto time = [&](const std::string& key, const std::string& text, const std::string& fallback, bool zero) {
    return Field{.path = d + key,
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "s",
                 .show = "s",
                 .fallback = fallback,
                 .range = {.low = 0.0, .low_open = !zero}};
  };
  std::vector<Field> rows = {
      {.path = "analysis", .text = "How to compute; the defaults serve."},
      {.path = m, .text = "Element lengths."},
      element(".overbend_element", "Over the supports."),
      element(".touchdown_element", "Around touchdown."),
      element(".longest_element", "Anywhere."),
      {.path = s, .text = "Statics."},
      {.path = s + ".method",
       .kind = FieldKind::choice,
       .text = "newton falls back on dynamic relaxation by itself; dynamic_relaxation always starts with it.",
       .fallback = "newton",
       .choices = {"newton", "dynamic_relaxation"}},
      {.path = s + ".tolerance",
       .kind = FieldKind::number,
       .text = "Largest unbalanced nodal force over the total weight.",
       .fallback = "1e-9",
       .range = {.low = 0.0, .high = 1e-3, .low_open = true}},
      {.path = s + ".max_iterations",
       .kind = FieldKind::integer,
       .text = "Newton iterations of one stage before another way is tried.",
       .fallback = "60",
       .range = {.low = 1.0, .high = 1e6}},
      {.path = d, .text = "Dynamics.", .fallback_text = "no dynamic analysis"},
      time(".duration", "Simulated time that statistics count, from t = 0.", "", false),
      time(".build_up", "Time before t = 0 in which waves, current change and motion are brought in.", "60 s", true),
      time(".step", "Fixed time step.", "", false),
      time(".max_step", "Largest time step of the adaptive scheme.", "", false),
      {.path = d + ".spectral_radius",
       .kind = FieldKind::number,
       .text = "At infinite frequency: 1 keeps all, 0 kills all high-frequency motion.",
       .fallback = "0.8",
       .range = {.low = 0.0, .high = 1.0}},
      time(".output_step", "Time between stored results.", "0.5 s", false),
      {.path = d + ".seeds",
       .kind = FieldKind::integer,
       .text = "Number of seeds: 1, 2, ... up to this; or a list of seeds.",
       .fallback_text = "the seed of the waves",
       .range = {.low = 1.0, .high = 10000.0}},
      {.path = d + ".seeds",
       .kind = FieldKind::list,
       .text = "Seeds of the random waves, one realisation each.",
       .least = 1,
       .most = 10000},
      {.path = d + ".seeds[]", .kind = FieldKind::integer, .text = "One seed.", .range = {.low = 0.0, .high = 9e15}},
  };
  for (Field& row : rows) {
    if (row.path == d + ".duration") row.required = true;
    if (row.path == d + ".step" || row.path == d + ".max_step") row.fallback_text = "chosen by the program";
  }
  return rows;
}

}  // namespace overbend::field_rows
