#include "mechanics/stress.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

double von_mises(double axial, double hoop, double radial) {
  const double a = axial - hoop, b = hoop - radial, c = radial - axial;
  return std::sqrt(0.5 * (a * a + b * b + c * c));
}

/// Stress of the steel at a strain; no limit if that is not known.
double borne(const Section& section, double strain) {
  return section.bending && section.bending->steel ? section.bending->steel->at(std::abs(strain)).stress
                                                   : std::numeric_limits<double>::infinity();
}

/// Strain of the axis beyond the elastic one, as the neutral axis moves in bending under tension.
double moved_axis(const Section& section, const SectionLoads& loads) {
  if (!section.bending) {
    return 0.0;
  }
  return monotonic(*section.bending, level_at(*section.bending, loads.z),
                   std::max(loads.curvature, loads.largest_curvature))
      .mid_strain;
}

}  // namespace

SectionStress section_stress(const Section& section, const SectionLoads& loads) {
  const double outer = 0.5 * section.steel_diameter;
  const double inner = outer - section.wall_thickness;
  const double po = loads.external_pressure, pi = loads.internal_pressure;
  const double wall = outer * outer - inner * inner;
  const double mean = (pi * inner * inner - po * outer * outer) / wall;  // Lame: mean -+ difference r_i^2 r_o^2 / r^2
  const double difference = (pi - po) * inner * inner * outer * outer / wall;
  // A solid bar is under the same pressure all over.
  const auto differs = [&](double radius) { return radius > 0.0 ? difference / (radius * radius) : 0.0; };

  SectionStress stress;
  stress.wall_tension = loads.effective_tension - po * section.pressure_area + pi * section.internal_area;
  stress.axial = stress.wall_tension / section.steel_area;
  const double nominal = loads.bending_moment * section.youngs_modulus / section.EI * outer;  // the stress in the steel
  const double largest = std::max(loads.curvature, loads.largest_curvature);
  stress.bending = std::min(nominal, borne(section, largest * outer));
  stress.hoop = mean + differs(inner);
  // The rod's law N = EA eps + (1 - 2 nu)(p_e A_e - p_i A_i), solved for the strain.
  const double poisson = 1.0 - 2.0 * section.poissons_ratio;
  const double axial_strain =
      (loads.effective_tension - poisson * (po * section.pressure_area - pi * section.internal_area)) / section.EA +
      moved_axis(section, loads);
  stress.strain =
      std::max(std::abs(axial_strain + loads.curvature * outer), std::abs(axial_strain - loads.curvature * outer));
  for (const double radius : {outer, inner}) {
    const double hoop = mean + differs(radius);
    const double radial = mean - differs(radius);
    for (const double side : {-1.0, 1.0}) {
      const double most = borne(section, std::abs(axial_strain) + largest * radius);
      const double longitudinal = std::clamp(stress.axial + side * nominal * radius / outer, -most, most);
      stress.von_mises = std::max(stress.von_mises, von_mises(longitudinal, hoop, radial));
    }
  }
  return stress;
}

}  // namespace overbend
