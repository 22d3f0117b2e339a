#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "model/new_model.h"

namespace overbend {
namespace {

double coated_radius(const NewModel& model) {
  return 0.5 * model.diameter + model.coating + model.concrete;
}

/// Returns the height of the underside of the pipe on the circle of ramp and stinger, frame S [m].
double underside(const NewModel& model, double x) {
  const double along = x - model.circle_start, radius = model.stinger_radius;
  return model.tensioner_height - coated_radius(model) - radius + std::sqrt(radius * radius - along * along);
}

std::string head_text(const NewModel& model) {
  return fmt::format(R"(# {title}
{note}# A first model to start from. Run it with: overbend static FILE -o DIR
# Every dimensional value carries its unit; any unit of the right dimension will do. All keys: docs/input.md.
overbend: 1
title: "{title}"

environment:
  water_depth: {depth}
  water_weight_density: 10.05 kN/m^3
  seabed:
    stiffness: 100 kN/m^2              # normal force per length of pipe and penetration
    friction: {{axial: 0.5, lateral: 0.5}}
  # current:                           # by increasing depth
  #   - {{depth: 0 m, speed: 0.5 m/s, towards: 0 deg}}
  #   - {{depth: {depth}, speed: 0.1 m/s, towards: 0 deg}}
)",
                     fmt::arg("title", model.title),
                     fmt::arg("note", model.note.empty() ? "" : "# Note: " + model.note + "\n"),
                     fmt::arg("depth", text_or_value(model.said.depth, model.depth, "m", "m")));
}

std::string pipe_text(const NewModel& model) {
  std::string text = fmt::format(R"(
pipe:
  steel:
    outside_diameter: {}
    wall_thickness: {}
    youngs_modulus: 207 GPa
    poissons_ratio: 0.3
    yield_stress: {}
    weight_density: 77 kN/m^3
)",
                                 text_or_value(model.said.pipe, model.diameter, "m", "mm"),
                                 text_or_value(model.said.wall, model.wall, "m", "mm"),
                                 text_or_value(model.said.yield, model.yield, "N/m^2", "MPa"));
  if (model.coating > 0.0 || model.concrete > 0.0) {
    text += "  coatings:                            # from the steel outwards\n";
  }
  if (model.coating > 0.0) {
    text += fmt::format("    - {{name: corrosion coating, thickness: {}, weight_density: 9.32 kN/m^3}}\n",
                        text_or_value(model.said.coating, model.coating, "m", "mm"));
  }
  if (model.concrete > 0.0) {
    text += fmt::format("    - {{name: concrete, thickness: {}, weight_density: 22 kN/m^3}}\n",
                        text_or_value(model.said.concrete, model.concrete, "m", "mm"));
    text += "  joint: {length: 12.2 m, field_joint: 0.7 m, infill_weight_density: 10.065 kN/m^3}\n";
  }
  return text + fmt::format("  # submerged weight {:.4g} kN/m\n", model.submerged_weight / 1e3);
}

std::string vessel_text(const NewModel& model) {
  const VesselSize size = vessel_size(model.vessel);
  const double deck = size.depth - size.draught;
  return fmt::format(R"(
vessel:
  name: {}
  length: {:.6g} m
  beam: {:.6g} m
  depth: {:.6g} m
  draught: {:.6g} m
  heading: 90 deg                      # the bow points to this azimuth
  stern_shoe: {{x: {:.6g} m, z: {:.6g} m}}   # x from midship, z above the water; origin of the frame below
  motion: fixed
)",
                     model.vessel, size.length, size.beam, size.depth, size.draught, -0.5 * size.length, deck);
}

std::string tension_text(const NewModel& model) {
  return text_or_value(model.said.tension, model.tension, "N", "kN");
}

std::string tower_text(const NewModel& model) {
  return fmt::format(R"(
tensioner:                             # the pipe hangs directly from it: no supports
  x: 0 m                               # from the stern shoe, positive astern; the pipe's axis
  z: {:.6g} m
  incline: {:.4g} deg                   # from horizontal
  guide: pinned
  tension: {}
)",
                     model.tensioner_height, model.departure_angle * kToDegrees, tension_text(model));
}

std::string boxes_text(const NewModel& model, const char* name, double first, double last, int count) {
  const double spacing = count > 1 ? (last - first) / (count - 1) : 4.0;
  std::string text = fmt::format(
      "  {}:                              # boxes on a circle of {}\n    roller: v\n    rows: 2\n    boxes:\n", name,
      text_or_value(model.said.stinger_radius, model.stinger_radius, "m", "m"));
  for (int i = 0; i < count; ++i) {
    const double x = count > 1 ? first + i * spacing : last;
    text += fmt::format("      - {{name: {} {}, x: {:.3f} m, z: {:.3f} m, length: {:.3g} m}}\n", name, i + 1, x,
                        underside(model, x), std::min(3.0, 0.6 * spacing));
  }
  return text;
}

std::string supports_text(const NewModel& model) {
  std::string text =
      fmt::format(R"(
tensioner:
  x: {:.3f} m                       # from the stern shoe, positive astern, z up; the pipe's axis
  z: {:.3f} m
  tension: {}                      # a catenary of this tension leaves at {:.3g} deg

rollers:                               # types of roller row, used by name below
  v:
    bottom: {{radius: 0.15 m, face: {face:.3g} m}}
    sides: {{radius: 0.15 m, face: {face:.3g} m, angle: 60 deg, clearance: 0.05 m}}
    friction: {{axial: 0.02, lateral: 0.3}}

supports:                              # x, z: where the underside of the coated pipe rests, mid-box
)",
                  model.circle_start - 10.0, model.tensioner_height, tension_text(model),
                  model.departure_angle * kToDegrees, fmt::arg("face", std::max(0.6, 2.5 * coated_radius(model))));
  text += boxes_text(model, "ramp", model.circle_start, -0.5, model.ramp_boxes);
  return text + boxes_text(model, "stinger", model.stinger_start, model.stinger_tip, model.boxes);
}

}  // namespace

std::string model_text(const NewModel& model) {
  return head_text(model) + pipe_text(model) + vessel_text(model) +
         (model.stinger ? supports_text(model) : tower_text(model));
}

}  // namespace overbend
