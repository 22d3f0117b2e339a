#include "modelfile/binding/line_resolution.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/pipe/line_types.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

void resolve_type(LineTypeDescription& type, double water_weight_density) {
  if (std::isnan(type.volume_diameter)) type.volume_diameter = type.diameter;
  if (std::isnan(type.drag_diameter)) type.drag_diameter = type.diameter;
  if (std::isnan(type.weight_submerged)) type.weight_submerged = submerged_weight(type, water_weight_density);
  if (type.made_from.empty()) type.made_from = kGivenNumbers;
}

/// Sets the type's numbers of a pipe segment, for code that uses only the type.
void resolve_pipe(LineSegmentDescription& segment, double water_weight_density) {
  segment.section->hydrodynamics = {segment.type.drag_normal, segment.type.drag_axial, segment.type.added_mass_normal,
                                    segment.type.added_mass_axial};
  const Section pipe = derive_section(segment.name, *segment.section, water_weight_density);
  LineTypeDescription& type = segment.type;
  type.name = segment.name;
  type.made_from = kGivenNumbers;
  type.diameter = type.volume_diameter = type.drag_diameter = pipe.outer_diameter;
  type.weight_in_air = pipe.weight_in_air;
  type.weight_submerged = pipe.weight_submerged;
  type.axial_stiffness = pipe.EA;
  type.bending_stiffness = pipe.EI;
  type.compression = true;
}

/// The name of the type has been checked before.
void resolve_segment(LineSegmentDescription& segment, const std::vector<LineTypeDescription>& types,
                     double water_weight_density) {
  if (segment.section) return resolve_pipe(segment, water_weight_density);
  const auto named = std::find_if(types.begin(), types.end(),
                                  [&](const LineTypeDescription& type) { return type.name == segment.type.name; });
  if (!segment.type.name.empty() && named != types.end()) {
    segment.type = *named;
    return;
  }
  segment.type.name = segment.name;
  resolve_type(segment.type, water_weight_density);
}

void resolve_point(LinePointDescription& point, double water_weight_density) {
  const double weight = point.mass * kGravity;
  if (std::exchange(point.by_weight, false)) {
    point.volume = point.net_force / water_weight_density;
    point.net_force -= weight;
  }
  if (std::isnan(point.volume)) point.volume = (point.net_force + weight) / water_weight_density;
  if (std::isnan(point.added_mass)) point.added_mass = 0.5 * point.volume * water_weight_density / kGravity;
  if (point.kind == PointKind::clump) point.net_force = point.volume * water_weight_density - weight;
}

template <typename Line>
void resolve_line(Line& line, const std::vector<LineTypeDescription>& types, double water_weight_density) {
  for (LineSegmentDescription& segment : line.segments) resolve_segment(segment, types, water_weight_density);
  for (LinePointDescription& point : line.points) resolve_point(point, water_weight_density);
}

}  // namespace

void resolve_lines(Description& description) {
  const double water = description.environment.water_weight_density;
  std::vector<LineTypeDescription> types;
  if (description.moorings) {
    for (LineTypeDescription& type : description.moorings->types) resolve_type(type, water);
    types = description.moorings->types;
    for (MooringLineDescription& line : description.moorings->lines) resolve_line(line, types, water);
  }
  for (FreeLineDescription& line : description.lines) resolve_line(line, types, water);
  for (LinePointDescription& point : description.pipe.points) resolve_point(point, water);
}

}  // namespace overbend
