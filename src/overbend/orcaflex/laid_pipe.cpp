// The pipe being laid, and its tensioner.
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

constexpr double kDegree = kPi / 180.0;
constexpr double kAssumedYield = 415e6;  ///< Yield stress if neither file nor user gives one [Pa].

/// A segment inherits missing keys from the main section.
std::string steel_text(Translation& translation, const LineType& type, const std::string& indent,
                       bool is_segment = false) {
  const bool is_assumed = !type.yield_stress && !translation.options.yield_stress;
  const double yield = type.yield_stress.value_or(translation.options.yield_stress.value_or(kAssumedYield));
  std::string text = fmt::format(
      "{}steel: {{outside_diameter: {} mm, wall_thickness: {} mm, youngs_modulus: {} GPa, poissons_ratio: {}, "
      "yield_stress: {} MPa{}, weight_density: {} kN/m^3}}\n",
      indent, number_text(type.outside_diameter * 1e3),
      number_text((type.outside_diameter - type.inside_diameter) * 500.0), number_text(type.youngs_modulus / 1e9),
      number_text(type.poissons_ratio), number_text(yield / 1e6),
      is_assumed   ? ", yield_assumed: yes"
      : is_segment ? ", yield_assumed: no"
                   : "",
      number_text(type.density * translation.units.gravity / 1e3));
  if (type.coating > 0.0) {
    text += fmt::format("{}coatings:\n{}  - {{name: coating, thickness: {} mm, weight_density: {} kN/m^3}}\n", indent,
                        indent, number_text(type.coating * 1e3),
                        number_text(type.coating_density * translation.units.gravity / 1e3));
  }
  return text;
}

/// Contents and lining as one contents of the same mass in the bore of the steel.
std::string contents_text(Translation& translation, const Line& line, const LineType& type, const std::string& indent,
                          bool is_segment = false) {
  const double mass = type.mass_inside(line.contents_density);
  if (mass <= 0.0) return is_segment ? indent + "contents: {weight_density: 0 kN/m^3}\n" : "";
  if (type.lining > 0.0) {
    translation.approximated(
        fmt::format("lining of {} m in {}, and contents in the bore within it: contents of the same mass in "
                    "the bore of the steel (exact in weight)",
                    number_text(type.lining), for_display(type.name)));
  }
  return fmt::format("{}contents: {{weight_density: {} kN/m^3}}\n", indent,
                     number_text(mass / type.area_inside() * translation.units.gravity / 1e3));
}

std::string hydrodynamics_text(const LineType& type, const std::string& indent) {
  return fmt::format("{}hydrodynamics: {{drag_normal: {}, drag_axial: {}, added_mass_normal: {}}}\n", indent,
                     number_text(type.drag_normal), number_text(type.drag_axial), number_text(type.added_mass_normal));
}

/// Sections before the last one, which is the main section.
std::string segments_text(Translation& translation, const Line& line) {
  if (line.pieces.size() < 2) return "";
  std::string text = "  segments:\n";
  for (std::size_t i = 0; i + 1 < line.pieces.size(); ++i) {
    const Piece& piece = line.pieces[i];
    text += fmt::format("    - name: {}\n      length: {} m\n", name_text(piece.type->name), number_text(piece.length));
    text += steel_text(translation, *piece.type, "      ", true);
    if (piece.type->coating == 0.0) text += "      coatings: []\n";
    text += contents_text(translation, line, *piece.type, "      ", true) + hydrodynamics_text(*piece.type, "      ");
  }
  return text;
}

/// Distance of the anchor astern of the stern shoe. An anchor off the vessel's axis is an error.
double anchor_distance(const Translation& translation, const Line& line) {
  const Vec3 anchor = translation.vessel.from_global(line.ends[1].point);
  if (std::abs(anchor.y()) > 1e-3 * std::abs(anchor.x())) {
    line.object->reject("ConnectionY",
                        fmt::format("an anchor {} m off the axis of the vessel", number_text(anchor.y())),
                        "an anchor astern, where the pipe is laid");
  }
  return translation.vessel.stern_shoe - anchor.x();
}

/// Winch on the free end of the pipe.
std::optional<Object> find_winch(const Translation& translation, const Line& line) {
  for (const Object& winch : translation.objects("Winches")) {
    const std::optional<Table> places = winch.table("Connection");
    for (std::size_t row = 0; places && row < places->size(); ++row) {
      if (places->text(row, "Connection") == line.name) return winch;
    }
  }
  return std::nullopt;
}

/// Tension of the winch in its first stage [N].
double winch_tension(Translation& translation, const Object& winch) {
  const std::optional<Table> stages = winch.table("StageMode");
  if (!stages || stages->size() == 0 || stages->text(0, "StageMode") != "Specified tension") {
    winch.reject("StageMode",
                 stages && stages->size() > 0 ? "'" + for_display(stages->text(0, "StageMode")) + "'" : "nothing",
                 "'Specified tension'", "a winch of given length has no counterpart: give the end of the pipe a place");
    return 0.0;
  }
  const double tension = stages->number(0, "StageValue").value_or(0.0) * translation.units.force;
  for (std::size_t row = 1; row < stages->size(); ++row) {
    const bool same = stages->text(row, "StageMode") == "Specified tension" &&
                      stages->number(row, "StageValue").value_or(0.0) * translation.units.force == tension;
    if (same) continue;
    translation.left_out("stages of winch " + for_display(winch.name()) + " after the first, which differ", true);
    break;
  }
  return tension;
}

}  // namespace

std::string pipe_text(Translation& translation) {
  const Line* line = translation.laid_pipe();
  if (line == nullptr) return "";
  for (const Piece& piece : line->pieces) {
    if (piece.type->is_pipe) continue;
    line->object->reject("LineType", "'" + for_display(piece.type->name) + "' of category General",
                         "a Homogeneous pipe");
    return "";
  }
  const LineType& main = *line->pieces.back().type;
  std::string text = "pipe:\n" + steel_text(translation, main, "  ") + contents_text(translation, *line, main, "  ") +
                     hydrodynamics_text(main, "  ") + segments_text(translation, *line);
  if (!main.yield_stress && !translation.options.yield_stress) {
    translation.left_out(
        "yield stress of the steel: the file has none, the model has 415 MPa and says so (yield_assumed); code checks "
        "mean nothing until it is given");
  }
  translation.left_out("segment lengths: the program meshes by itself");
  if (line->ends[0].kind == LineEnd::Kind::free) return text + "\n";
  text += fmt::format("  length: {} m\n  anchor: {} m\n", number_text(line->length()),
                      number_text(anchor_distance(translation, *line)));
  translation.translated(fmt::format("pipe {}: steel, layers, length {} m, anchor {} m astern of the stern shoe",
                                     for_display(line->name), number_text(line->length()),
                                     number_text(anchor_distance(translation, *line))));
  return text + "\n";
}

std::string tensioner_text(Translation& translation) {
  const Line* line = translation.laid_pipe();
  if (line == nullptr) return "";
  const LineEnd& end = line->ends[0];
  const bool is_free = end.kind == LineEnd::Kind::free;
  const Vec3 point = is_free ? translation.vessel.from_global(end.point) : end.point;
  // Azimuths at a vessel are in its axes, those of a free end global.
  const double azimuth = is_free ? end.azimuth - translation.vessel.heading : end.azimuth;
  const bool is_level_across = std::abs(std::sin(end.declination)) * std::abs(std::sin(azimuth)) < 1e-6;
  if (!is_level_across || std::cos(azimuth) > 0.0 || std::abs(point.y()) > 1e-3) {
    line->object->reject("ConnectionAzimuth",
                         fmt::format("{} deg, {} m to port", number_text(azimuth / kDegree), number_text(point.y())),
                         "180 deg: astern, on the axis of the vessel");
  }
  if (end.stiffness) {
    translation.left_out("spring against rotation at the upper end of the pipe: the end is free to rotate", true);
  }
  const double height = point.z() + translation.vessel.position.z();
  std::string text = fmt::format("tensioner: {{x: {} m, z: {} m, incline: {} deg, guide: {}",
                                 number_text(translation.vessel.stern_shoe - point.x()), number_text(height),
                                 number_text(end.declination / kDegree - 90.0), end.is_clamped ? "clamped" : "pinned");
  if (is_free) {
    if (const std::optional<Object> winch = find_winch(translation, *line)) {
      const double tension = winch_tension(translation, *winch);
      text += fmt::format(", tension: {} kN, mode: constant", number_text(tension / 1e3));
      translation.approximated(
          fmt::format("winch {} on the free end: tensioner at the place of the end, tension {} kN; length and anchor "
                      "follow from it, in "
                      "place of the file's {} m and {} m",
                      for_display(winch->name()), number_text(tension / 1e3), number_text(line->length()),
                      number_text(anchor_distance(translation, *line))));
      translation.left_out("wire of winch " + for_display(winch->name()) + ": no part of the model");
    }
  }
  return text + "}\n\n";
}

}  // namespace overbend::orcaflex
