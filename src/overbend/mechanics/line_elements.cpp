#include "mechanics/line_elements.h"

#include <cmath>
#include <numbers>

namespace overbend {

LineElements line_elements(const Model& model, const std::vector<double>& lengths, const std::vector<int>& sections) {
  LineElements e;
  e.count = static_cast<int>(lengths.size());
  const std::size_t padded = (lengths.size() + kLanes - 1) / kLanes * kLanes;
  for (AlignedDoubles* array :
       {&e.EA, &e.EI, &e.weight, &e.buoyancy, &e.radius, &e.drag_normal, &e.drag_axial, &e.pressure_constant,
        &e.pressure_slope, &e.pressure_external, &e.mass, &e.displaced_mass, &e.added_normal, &e.added_axial}) {
    array->assign(padded, 0.0);
  }
  e.length.assign(padded, 1.0);
  e.radius.assign(padded, 1.0);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    const Section& section = model.sections[static_cast<std::size_t>(sections[i])];
    const double poisson = 1.0 - 2.0 * section.poissons_ratio;
    e.length[i] = lengths[i];
    e.EA[i] = section.EA;
    e.EI[i] = section.EI;
    e.weight[i] = section.weight_in_air;
    e.buoyancy[i] = model.water_weight_density * section.external_area;
    e.radius[i] = section.outer_radius();
    e.drag_normal[i] = 0.5 * model.water_density * section.drag_normal * section.outer_diameter;
    e.drag_axial[i] = 0.5 * model.water_density * std::numbers::pi * section.outer_diameter * section.drag_axial;
    e.pressure_constant[i] = -poisson * section.internal_pressure * section.internal_area;
    e.pressure_slope[i] = poisson * section.contents_weight_density * section.internal_area;
    e.pressure_external[i] = poisson * model.water_weight_density * section.pressure_area;
    e.mass[i] = section.mass();
    e.displaced_mass[i] = model.water_density * section.external_area;
    e.added_normal[i] = section.added_mass_normal * e.displaced_mass[i];
    e.added_axial[i] = section.added_mass_axial * e.displaced_mass[i];
  }
  return e;
}

LineEnvironment line_environment(const Model& model, const LayRoute& route) {
  LineEnvironment env;
  const BedSurface& bed = model.seabed.surface;
  const Vec3 start = route.place(0.0);
  const Vec3 along = bed.along(start, route.direction(0.0));
  for (int i = 0; i < 3; ++i) {
    env.bed_normal[i] = bed.normal(start.x(), start.y())(i);
    env.route_normal[i] = route.port(0.0)(i);
    env.bed_along[i] = along(i);
  }
  env.bed_offset = bed.offset();
  env.bed_stiffness = model.seabed.stiffness;
  env.bed_friction_lateral = model.seabed.friction_lateral;
  env.bed_friction_axial = model.seabed.friction_axial;
  env.bed_stick = model.seabed.stiffness;
  env.bed_damping = model.description.environment.seabed.damping;
  env.route_offset = route.port_offset();
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
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return isa_avx512::line_energy(elements.view(), env, shape, motion);
  }
  if (isa == Isa::avx2) {
    return isa_avx2::line_energy(elements.view(), env, shape, motion);
  }
#endif
  (void)isa;
  return isa_baseline::line_energy(elements.view(), env, shape, motion);
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
