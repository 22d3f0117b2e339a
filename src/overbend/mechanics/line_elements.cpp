#include "mechanics/line_elements.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/element_constants.h"
#include "mechanics/slack_law.h"
#include "model/lay_stage.h"
#include "model/pipe/line_types.h"
#include "model/site/seabed_shape.h"

namespace overbend {
namespace {

/// Returns the bending stiffness [N m2] that keeps a slack line from having no lateral stiffness: a hundredth of a wire
/// rope's, which is a thousandth of EA D^2 (a solid bar has EA D^2/16); if a model gives an unlimited EA, the stiffness
/// that bends under its own weight over a metre.
double min_bending_stiffness(const LineTypeDescription& type, double diameter) {
  constexpr double kShare = 1e-5, kMetre = 1.0;
  return std::min(kShare * type.axial_stiffness * diameter * diameter, type.weight_in_air * std::pow(kMetre, 3));
}

/// Sets the damping of tension-only elements. The first axial mode of a line fixed at one end is a quarter wave: its
/// frequency is pi/2 over the travel time of an axial wave through the line.
void set_damping(LineElements& e) {
  double time = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (e.compression[i] < 1.0) time += e.length[i] * std::sqrt(e.mass[i] / e.EA[i]);
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(e.count); ++i) {
    if (e.compression[i] < 1.0) e.damping[i] = 4.0 / std::numbers::pi * kSlackDamping * time;
  }
}

/// Returns the friction coefficient of a line dragged along the seabed, positive away from the vessel [-].
double drag_on_bed(const Model& model, const Section& section) {
  const double direction = dragging_direction(model.description);
  if (direction == 0.0) return 0.0;
  const bool cable = section.kind == SectionKind::cable;
  const double axial = model.seabed.friction_axial;
  return -direction * (cable ? model.description.operation.lay.cable->friction.value_or(axial) : axial);
}

}  // namespace

ElementConstants pipe_constants(const Model& model, const Section& section) {
  const double poisson = 1.0 - 2.0 * section.poissons_ratio;
  ElementConstants c;
  c.EA = section.EA;
  c.EI = section.EI;
  if (section.kind == SectionKind::cable) c.compression = kSlackShare;
  c.weight = section.weight_in_air;
  c.buoyancy = model.water_weight_density * section.external_area;
  c.radius = section.outer_radius();
  c.drag_normal = 0.5 * model.water_density * section.drag_normal * section.outer_diameter;
  c.drag_axial = 0.5 * model.water_density * std::numbers::pi * section.outer_diameter * section.drag_axial;
  c.pressure_constant = -poisson * section.internal_pressure * section.internal_area;
  c.pressure_slope = poisson * section.contents_weight_density * section.internal_area;
  c.pressure_external = poisson * model.water_weight_density * section.pressure_area;
  c.mass = section.mass();
  c.displaced_mass = model.water_density * section.external_area;
  c.added_normal = section.added_mass_normal * c.displaced_mass;
  c.added_axial = section.added_mass_axial * c.displaced_mass;
  c.drag_on_bed = drag_on_bed(model, section);
  return c;
}

ElementConstants cable_constants(const Model& model, const LineTypeDescription& type) {
  const double drag_diameter = type.drag_diameter > 0.0 ? type.drag_diameter : type.diameter;
  const double area = (type.weight_in_air - type.weight_submerged) / model.water_weight_density;
  ElementConstants c;
  c.EA = type.axial_stiffness;
  c.weight = type.weight_in_air;
  c.buoyancy = type.weight_in_air - type.weight_submerged;
  c.radius = area > 0.0 ? std::sqrt(area / std::numbers::pi) : 0.5 * type.diameter;
  c.EI = std::max(type.bending_stiffness, min_bending_stiffness(type, 2.0 * c.radius));
  if (!bears_compression(type)) c.compression = kSlackShare;
  c.drag_normal = 0.5 * model.water_density * type.drag_normal * drag_diameter;
  c.drag_axial = 0.5 * model.water_density * std::numbers::pi * drag_diameter * type.drag_axial;
  c.mass = type.weight_in_air / kGravity;
  c.displaced_mass = model.water_density * area;
  c.added_normal = type.added_mass_normal * c.displaced_mass;
  c.added_axial = type.added_mass_axial * c.displaced_mass;
  return c;
}

LineElements make_elements_by_kind(const std::vector<double>& lengths, const std::vector<int>& kinds,
                                   const std::vector<ElementConstants>& constants) {
  LineElements e;
  e.count = static_cast<int>(lengths.size());
  const std::size_t padded = (lengths.size() + kLanes - 1) / kLanes * kLanes;
  e.length.assign(padded, 1.0);
  std::copy(lengths.begin(), lengths.end(), e.length.begin());
  const auto fill = [&](AlignedDoubles& values, double ElementConstants::*member, double beyond) {
    values.assign(padded, beyond);
    for (std::size_t i = 0; i < kinds.size(); ++i) values[i] = constants[static_cast<std::size_t>(kinds[i])].*member;
  };
  fill(e.EA, &ElementConstants::EA, 0.0);
  fill(e.EI, &ElementConstants::EI, 0.0);
  fill(e.compression, &ElementConstants::compression, 1.0);
  e.damping.assign(padded, 0.0);
  fill(e.weight, &ElementConstants::weight, 0.0);
  fill(e.buoyancy, &ElementConstants::buoyancy, 0.0);
  fill(e.radius, &ElementConstants::radius, 1.0);
  fill(e.drag_normal, &ElementConstants::drag_normal, 0.0);
  fill(e.drag_axial, &ElementConstants::drag_axial, 0.0);
  fill(e.pressure_constant, &ElementConstants::pressure_constant, 0.0);
  fill(e.pressure_slope, &ElementConstants::pressure_slope, 0.0);
  fill(e.pressure_external, &ElementConstants::pressure_external, 0.0);
  fill(e.mass, &ElementConstants::mass, 0.0);
  fill(e.displaced_mass, &ElementConstants::displaced_mass, 0.0);
  fill(e.added_normal, &ElementConstants::added_normal, 0.0);
  fill(e.added_axial, &ElementConstants::added_axial, 0.0);
  fill(e.drag_on_bed, &ElementConstants::drag_on_bed, 0.0);
  set_damping(e);
  return e;
}

LineElements line_elements(const Model& model, const std::vector<double>& lengths, const std::vector<int>& sections) {
  std::vector<ElementConstants> constants;
  constants.reserve(model.sections.size());
  for (const Section& section : model.sections) constants.push_back(pipe_constants(model, section));
  return make_elements_by_kind(lengths, sections, constants);
}

void set_shape(LineEnvironment& env, const SeabedSurface& bed) {
  if (bed.shape() == nullptr) return;
  env.bed_shape = bed.shape();
  env.bed_highest = std::max(bed.shape()->highest, bed.offset());
}

LineEnvironment line_environment(const Model& model, const LayRoute& route) {
  LineEnvironment env;
  const SeabedSurface& bed = model.seabed.surface;
  const Vec3 start = route.place(0.0);
  const Vec3 along = bed.along(start, route.direction(0.0));
  for (int i = 0; i < 3; ++i) {
    env.bed_normal[i] = bed.plane_normal()(i);
    env.route_normal[i] = route.port(0.0)(i);
    env.bed_along[i] = along(i);
  }
  env.bed_offset = bed.offset();
  set_shape(env, bed);
  env.bed_stiffness = model.seabed.stiffness;
  env.bed_friction_lateral = model.seabed.friction_lateral;
  env.bed_friction_axial = model.seabed.friction_axial;
  env.bed_stick = model.seabed.stiffness;
  env.dragged = is_dragged(model.description);
  env.bed_soil = static_cast<int>(model.description.environment.seabed.soil);
  env.bed_bearing = model.description.environment.seabed.bearing_force.value_or(0.0);
  env.bed_damping = model.description.environment.seabed.damping;
  env.route_offset = route.port_offset();
  if (!route.straight()) {
    env.route_pieces = static_cast<int>(route.pieces()->size());
    env.route = route.pieces()->data();
    env.route_shift = route.shift();
  }
  env.current_rows = static_cast<int>(model.current.z.size());
  env.current_z = model.current.z.data();
  env.current_vx = model.current.vx.data();
  env.current_vy = model.current.vy.data();
  return env;
}

LineView LineElements::view() const {
  LineView v{};
  v.count = count;
  v.length = length.data();
  v.EA = EA.data();
  v.EI = EI.data();
  v.compression = compression.data();
  v.damping = damping.data();
  v.weight = weight.data();
  v.buoyancy = buoyancy.data();
  v.radius = radius.data();
  v.drag_normal = drag_normal.data();
  v.drag_axial = drag_axial.data();
  v.pressure_constant = pressure_constant.data();
  v.pressure_slope = pressure_slope.data();
  v.pressure_external = pressure_external.data();
  v.mass = mass.data();
  v.displaced_mass = displaced_mass.data();
  v.added_normal = added_normal.data();
  v.added_axial = added_axial.data();
  v.drag_on_bed = drag_on_bed.data();
  return v;
}

void add_line_forces(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target, Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return isa_avx512::add_line_forces(elements.view(), env, shape, target);
  }
  if (isa == Isa::avx2) {
    return isa_avx2::add_line_forces(elements.view(), env, shape, target);
  }
#endif
  (void)isa;
  isa_baseline::add_line_forces(elements.view(), env, shape, target);
}

void add_line_forces(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                     const LineMotion& motion, const LineTarget& target, Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return isa_avx512::add_moving_line_forces(elements.view(), env, shape, motion, target);
  }
  if (isa == Isa::avx2) {
    return isa_avx2::add_moving_line_forces(elements.view(), env, shape, motion, target);
  }
#endif
  (void)isa;
  isa_baseline::add_moving_line_forces(elements.view(), env, shape, motion, target);
}

LineEnergy line_energy(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                       const LineMotion& motion, Isa isa) {
  LineMotion current_motion = motion;
  current_motion.step = 0.0;
  current_motion.bed_slip_next = nullptr;
  LineEnergy energy;
  LineTarget target;
  target.energy = &energy;
  add_line_forces(elements, env, shape, current_motion, target, isa);
  return energy;
}

WettedFraction wetted_fraction(double z, double radius) {
  const double c = z / radius;
  if (c <= -1.0) {
    return {1.0, 0.0};
  }
  if (c >= 1.0) {
    return {0.0, 0.0};
  }
  const double half_chord = std::sqrt(1.0 - c * c);
  return {(std::acos(c) - c * half_chord) / std::numbers::pi, -2.0 * half_chord / (std::numbers::pi * radius)};
}

}  // namespace overbend
