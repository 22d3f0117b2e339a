/// Stresses of the steel section from the resultants of the rod.
///
/// Effective tension N and true wall tension differ by the pressures on the surfaces of the steel. The coating is under
/// water pressure all round and carries no further axial force, so it drops out: A_e is the area of the steel's outside
/// diameter.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/pipe/section.h"

namespace overbend {

struct SectionLoads {
  double effective_tension = 0.0;  ///< [N]
  double bending_moment = 0.0;     ///< Magnitude [N m].
  double curvature = 0.0;          ///< Magnitude [1/m].
  double max_curvature = 0.0;      ///< Maximum curvature at which the section has yielded so far [1/m].
  double external_pressure = 0.0;  ///< [Pa]
  double internal_pressure = 0.0;  ///< [Pa]
  double z = 0.0;                  ///< Height, which selects the springs of yielding steel [m].
};

struct SectionStress {
  double wall_tension = 0.0;  ///< N - p_e A_e + p_i A_i, in the steel [N].
  double axial = 0.0;         ///< [Pa]
  double bending = 0.0;       ///< At the outer fibre, M D / (2 I), or the stress of yielding steel at its strain [Pa].
  double hoop = 0.0;          ///< Lame, inner wall [Pa].
  double von_mises = 0.0;     ///< Maximum over inner and outer wall, both bending extremes [Pa].
  double strain = 0.0;        ///< Maximum longitudinal strain magnitude at the outer fibre.
};

/// Returns stresses and strain: Lame for hoop and radial stress; von Mises at the extreme fibres of outer and inner
/// wall.
///
/// For yielding steel the strain is that of the curvature about the neutral axis, which has moved according to the
/// maximum curvature so far. The stress of a fibre is the elastic one of the moment, limited to the stress-strain curve
/// at that maximum curvature: correct during loading, with elastic unloading. Residual stresses from yielding are not
/// included. Where only moments are known the elastic stress of the moment applies.
SectionStress section_stress(const Section& section, const SectionLoads& loads);

/// Precomputed section data for stresses at many points: quotients are stored, since a division costs as much as the
/// rest of the formula's terms.
struct SectionWall {
  explicit SectionWall(const Section& section)
      : outer(0.5 * section.steel_diameter),
        inner(outer - section.wall_thickness),
        outer_share(outer * outer / (outer * outer - inner * inner)),
        inner_share(inner * inner / (outer * outer - inner * inner)),
        bore_share(inner > 0.0 ? outer_share : 0.0),
        pressure_area(section.pressure_area),
        internal_area(section.internal_area),
        per_area(1.0 / section.steel_area),
        per_moment(section.youngs_modulus / section.EI * outer),
        inner_to_outer(inner / outer),
        per_EA(1.0 / section.EA),
        poisson(1.0 - 2.0 * section.poissons_ratio) {}

  double outer, inner;  ///< Radii of the steel [m].
  /// r_o^2 and r_i^2 over r_o^2 - r_i^2; the former again for the inner wall, which a solid bar does not have: it has
  /// the same pressure throughout.
  double outer_share, inner_share, bore_share;
  double pressure_area, internal_area;  ///< As in Section [m2].
  double per_area;                      ///< 1 / steel area [1/m2]
  double per_moment;                    ///< Stress at the outer fibre per unit moment, E r_o / EI [1/m3].
  double inner_to_outer;                ///< r_i / r_o
  double per_EA;                        ///< [1/N]
  double poisson;                       ///< 1 - 2 nu [-]
};

/// Formula of section_stress(). `moved_axis`: strain of the axis beyond the elastic one. `limited(stress, strain)`:
/// stress limited to the steel's capacity at the strain. Without branches, so that the compiler vectorises a loop over
/// points.
template <typename Limit>
inline SectionStress stress_of_wall(const SectionWall& wall, const SectionLoads& loads, double moved_axis,
                                    const Limit& limited) {
  const double outer = wall.outer, inner = wall.inner;
  const double po = loads.external_pressure, pi = loads.internal_pressure;
  // Lame: mean -+ difference r_i^2 r_o^2 / r^2
  const double mean = pi * wall.inner_share - po * wall.outer_share;
  const double at_outer = (pi - po) * wall.inner_share, at_inner = (pi - po) * wall.bore_share;

  SectionStress stress;
  stress.wall_tension = loads.effective_tension - po * wall.pressure_area + pi * wall.internal_area;
  stress.axial = stress.wall_tension * wall.per_area;
  const double nominal = loads.bending_moment * wall.per_moment;  // the stress in the steel
  const double max_curvature = std::max(loads.curvature, loads.max_curvature);
  stress.bending = limited(nominal, max_curvature * outer);
  stress.hoop = mean + at_inner;
  // The rod's law N = EA eps + (1 - 2 nu)(p_e A_e - p_i A_i), solved for the strain.
  const double axial_strain =
      (loads.effective_tension - wall.poisson * (po * wall.pressure_area - pi * wall.internal_area)) * wall.per_EA +
      moved_axis;
  stress.strain =
      std::max(std::abs(axial_strain + loads.curvature * outer), std::abs(axial_strain - loads.curvature * outer));
  const double nominal_inside = nominal * wall.inner_to_outer;
  const auto squared = [&](double radius, double pressed, double bending) {
    const double hoop = mean + pressed, radial = mean - pressed;
    const double longitudinal = limited(stress.axial + bending, std::abs(axial_strain) + max_curvature * radius);
    const double a = longitudinal - hoop, b = hoop - radial, c = radial - longitudinal;
    return 0.5 * (a * a + b * b + c * c);
  };
  stress.von_mises = std::sqrt(
      std::max(std::max(squared(outer, at_outer, -nominal), squared(outer, at_outer, nominal)),
               std::max(squared(inner, at_inner, -nominal_inside), squared(inner, at_inner, nominal_inside))));
  return stress;
}

}  // namespace overbend
