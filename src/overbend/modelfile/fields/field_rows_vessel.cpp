#include <array>

#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows.h"

namespace overbend::field_rows {
namespace {

/// Key that names the file of the motion.
Field motion_file(VesselMotion motion, const char* text) {
  const auto take = [motion](VesselDescription& vessel, const FieldValue& file) {
    vessel.motion = motion;
    vessel.motion_file = file.text;
  };
  return {.path = std::string("vessel.motion.") + enum_name(motion),
          .member = taken_by<VesselDescription>(take),
          .kind = FieldKind::text,
          .file = true,
          .text = text};
}

VesselDescription& take_harmonic(VesselDescription& vessel, const FieldValue&) {
  vessel.motion = VesselMotion::harmonic;
  return vessel;
}

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
  std::vector<Field> rows = {{.path = p,
                              .member = opened_by<VesselDescription>(take_harmonic),
                              .text = "Prescribed motion amplitude * sin(2 pi t / period + phase).",
                              .min_items = 1}};
  for (const Freedom& f : kFreedoms) {
    const std::string key = p + "." + f.name;
    const auto freedom = [](VesselDescription& vessel, const FieldValue& group) -> HarmonicMotion& {
      return vessel.harmonic[group.key];
    };
    rows.push_back({.path = key, .member = opened_by<VesselDescription>(freedom), .text = f.text});
    rows.push_back({.path = key + ".amplitude",
                    .member = fills(&HarmonicMotion::amplitude),
                    .kind = FieldKind::quantity,
                    .text = "Amplitude.",
                    .unit = f.unit,
                    .show = f.show,
                    .required = true,
                    .range = {.low = 0.0}});
    rows.push_back({.path = key + ".period",
                    .member = fills(&HarmonicMotion::period),
                    .kind = FieldKind::quantity,
                    .text = "Period.",
                    .unit = "s",
                    .show = "s",
                    .required = true,
                    .range = {.low = 0.1}});
    rows.push_back({.path = key + ".phase",
                    .member = defaults(&HarmonicMotion::phase),
                    .kind = FieldKind::quantity,
                    .text = "Phase at t = 0.",
                    .unit = "rad",
                    .show = "deg",
                    .range = azimuth()});
  }
  return rows;
}

/// Titles of a recorded motion, read by modelfile/reading/motion_files.h.
std::vector<Field> motion_columns() {
  return {
      {.path = "vessel.motion.columns",
       .member = read_elsewhere(),
       .text = "Meaning of columns of the motion history by their titles in the file.",
       .fallback_text = "by their titles",
       .min_items = 1,
       .max_items = 50},
      {.path = "vessel.motion.columns.*",
       .member = read_elsewhere(),
       .kind = FieldKind::text,
       .text = "Quantity with its unit, such as time, time_ms, heave_m or roll_rad, or `unused`."},
  };
}

}  // namespace

std::vector<Field> vessel() {
  const auto size = [](const std::string& key, double VesselDescription::*member, const std::string& text) {
    return Field{.path = "vessel." + key,
                 .member = defaults(member),
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "m",
                 .show = "m",
                 .range = {.low = 0.0, .high = 1000.0, .low_open = true}};
  };
  const auto tilt = [](const std::string& key, double VesselDescription::*member, const std::string& text) {
    return Field{.path = "vessel." + key,
                 .member = defaults(member),
                 .kind = FieldKind::quantity,
                 .text = text,
                 .unit = "rad",
                 .show = "deg",
                 .range = {.low = -45.0 * kDegree, .high = 45.0 * kDegree, .low_open = true, .high_open = true}};
  };
  std::vector<Field> rows = {
      {.path = "vessel",
       .member = enters(&Description::vessel),
       .text = "The lay vessel. Its frame: origin midship on the water, x forward, z up.",
       .fallback_text = "required with a pipe or moorings"},
      {.path = "vessel.name",
       .member = defaults(&VesselDescription::name),
       .kind = FieldKind::text,
       .text = "For the report."},
      size("length", &VesselDescription::length, "Overall."),
      size("beam", &VesselDescription::beam, "Width."),
      size("depth", &VesselDescription::depth, "Keel to deck."),
      size("draught", &VesselDescription::draught, "Keel to water line."),
      {.path = "vessel.heading",
       .member = defaults(&VesselDescription::heading),
       .kind = FieldKind::quantity,
       .text = "Azimuth of the bow, clockwise from north.",
       .unit = "rad",
       .show = "deg",
       .range = azimuth()},
      tilt("trim", &VesselDescription::trim, "Static trim, bow up positive, about midship at the water line."),
      tilt("heel", &VesselDescription::heel, "Static heel, starboard down positive, about the same point."),
      {.path = "vessel.stern_shoe",
       .text = "Origin of the ramp/stinger frame, in the vessel's frame.",
       .fallback_text = "required with a pipe"},
      {.path = "vessel.stern_shoe.x",
       .member = fills(&VesselDescription::stern_shoe_x),
       .kind = FieldKind::quantity,
       .text = "From midship, forward positive.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = -1000.0, .high = 1000.0}},
      {.path = "vessel.stern_shoe.z",
       .member = fills(&VesselDescription::stern_shoe_z),
       .kind = FieldKind::quantity,
       .text = "Above the water.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = -1000.0, .high = 1000.0}},
      {.path = "vessel.motion",
       .member = defaults(&VesselDescription::motion),
       .kind = FieldKind::choice,
       .text = "fixed, or a group with one of the keys below. Only dynamic analysis uses it.",
       .choices = {enum_name(VesselMotion::fixed)}},
      {.path = "vessel.motion",
       .text = "Source of the motion: one of raos, history, coupled, harmonic; with convention and columns if needed.",
       .min_items = 1,
       .max_items = 3},
      motion_file(
          VesselMotion::raos,
          "File of response amplitude operators, in the folder of the model file: .csv, .4 or .out (WAMIT), .LIS "
          "(AQWA), .yml (OrcaFlex), or one of the six .rao of HydroStar."),
      motion_file(VesselMotion::history,
                  "Table of the motion history, in the folder of the model file: time and any of surge to yaw, with "
                  "units in the "
                  "titles (time_s, heave_m, roll_deg) or in a line below them."),
  };
  append(rows, harmonic_motion());
  append(rows, motion_columns());
  return rows;
}

}  // namespace overbend::field_rows
