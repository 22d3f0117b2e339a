#include <array>

#include "modelfile/field_rows.h"

namespace overbend::field_rows {
namespace {

constexpr double kDeg = std::numbers::pi / 180.0;

/// `harmonic: {heave: {amplitude: 1 m, period: 8 s, phase: 0 deg}}` for each degree of freedom.
std::vector<Field> harmonic_motion() {
  struct Freedom {
    const char *name, *text, *unit, *show;
  };
  constexpr std::array<Freedom, 6> kFreedoms = {{{"surge", "Forward.", "m", "m"},
                                                 {"sway", "To port.", "m", "m"},
                                                 {"heave", "Up.", "m", "m"},
                                                 {"roll", "Starboard down.", "rad", "deg"},
                                                 {"pitch", "Bow down.", "rad", "deg"},
                                                 {"yaw", "Bow to port.", "rad", "deg"}}};
  const std::string p = "vessel.motion.harmonic";
  std::vector<Field> rows = {
      {.path = p, .text = "Prescribed motion amplitude * sin(2 pi t / period + phase).", .least = 1}};
  for (const Freedom& f : kFreedoms) {
    const std::string key = p + "." + f.name;
    rows.push_back({.path = key, .text = f.text});
    rows.push_back({.path = key + ".amplitude",
                    .kind = FieldKind::quantity,
                    .text = "Amplitude.",
                    .unit = f.unit,
                    .show = f.show,
                    .required = true,
                    .range = {.low = 0.0}});
    rows.push_back({.path = key + ".period",
                    .kind = FieldKind::quantity,
                    .text = "Period.",
                    .unit = "s",
                    .show = "s",
                    .required = true,
                    .range = {.low = 0.0, .low_open = true}});
    rows.push_back({.path = key + ".phase",
                    .kind = FieldKind::quantity,
                    .text = "Phase at t = 0.",
                    .unit = "rad",
                    .show = "deg",
                    .fallback = "0 deg",
                    .range = azimuth()});
  }
  return rows;
}

}  // namespace

std::vector<Field> vessel() {
  const auto size = [](const std::string& key, const std::string& text, const std::string& fallback) {
    return Field{.path = "vessel." + key,
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "m",
                 .show = "m",
                 .fallback = fallback,
                 .range = {.low = 0.0, .high = 1000.0, .low_open = true}};
  };
  const auto tilt = [](const std::string& key, const std::string& text) {
    return Field{.path = "vessel." + key,
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "rad",
                 .show = "deg",
                 .fallback = "0 deg",
                 .range = {.low = -45.0 * kDeg, .high = 45.0 * kDeg, .low_open = true, .high_open = true}};
  };
  std::vector<Field> rows = {
      {.path = "vessel",
       .text = "The lay vessel. Its frame: origin midship on the water, x forward, z up.",
       .required = true},
      {.path = "vessel.name", .kind = FieldKind::text, .text = "For the report.", .fallback = "barge"},
      size("length", "Overall.", "120 m"),
      size("beam", "Width.", "30 m"),
      size("depth", "Keel to deck.", "9 m"),
      size("draught", "Keel to water line.", "5 m"),
      {.path = "vessel.heading",
       .kind = FieldKind::quantity,
       .text = "Azimuth of the bow, clockwise from north.",
       .unit = "rad",
       .show = "deg",
       .fallback = "0 deg",
       .range = azimuth()},
      tilt("trim", "Static trim, bow up positive, about midship at the water line."),
      tilt("heel", "Static heel, starboard down positive, about the same point."),
      {.path = "vessel.stern_shoe",
       .text = "Origin of the ramp/stinger frame, in the vessel's frame.",
       .required = true},
      {.path = "vessel.stern_shoe.x",
       .kind = FieldKind::quantity,
       .text = "From midship, forward positive.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = -1000.0, .high = 1000.0}},
      {.path = "vessel.stern_shoe.z",
       .kind = FieldKind::quantity,
       .text = "Above the water.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = -1000.0, .high = 1000.0}},
      {.path = "vessel.motion",
       .kind = FieldKind::choice,
       .text = "fixed, or a group with one of the keys below. Only dynamics uses it.",
       .fallback = "fixed",
       .choices = {"fixed"}},
      {.path = "vessel.motion",
       .text = "Source of the motion: one of raos, history, coupled, harmonic; with convention if needed.",
       .least = 1,
       .most = 2},
      {.path = "vessel.motion.raos",
       .kind = FieldKind::text,
       .text = "File of response amplitude operators, in the folder of the model file: .csv, .4 (WAMIT) or .yml "
               "(OrcaFlex)."},
      {.path = "vessel.motion.history",
       .kind = FieldKind::text,
       .text =
           "CSV file of the motion history, in the folder of the model file: time_s and any of surge_m to yaw_deg."},
      {.path = "vessel.motion.coupled",
       .kind = FieldKind::text,
       .text = "File of the hydrodynamics of the hull, in the folder of the model file: coupled motion of pipe and "
               "vessel."},
  };
  const std::vector<Field> harmonic = harmonic_motion();
  rows.insert(rows.end(), harmonic.begin(), harmonic.end());
  return rows;
}

}  // namespace overbend::field_rows
