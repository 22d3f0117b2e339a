/// Stresses of the steel section from the resultants of the rod.
///
/// Effective tension N and true wall tension differ by the pressures on the surfaces of the steel. The coating stands
/// under water pressure all round, carries no axial force beyond that, and so drops out: A_e is the area of the steel's
/// outside diameter.
#pragma once

#include "model/section.h"

namespace overbend {

struct SectionLoads {
  double effective_tension = 0.0;  ///< [N]
  double bending_moment = 0.0;     ///< Magnitude [N m].
  double curvature = 0.0;          ///< Magnitude [1/m].
  double largest_curvature = 0.0;  ///< At which the section has yielded so far [1/m].
  double external_pressure = 0.0;  ///< [Pa]
  double internal_pressure = 0.0;  ///< [Pa]
  double z = 0.0;                  ///< Height, by which steel that yields finds its springs [m].
};

struct SectionStress {
  double wall_tension = 0.0;  ///< N - p_e A_e + p_i A_i, of the steel [N].
  double axial = 0.0;         ///< [Pa]
  double bending = 0.0;       ///< At the outer fibre, M D / (2 I), or what yielding steel bears at its strain [Pa].
  double hoop = 0.0;          ///< Lame, inner wall [Pa].
  double von_mises = 0.0;     ///< Largest over inner and outer wall, both bending extremes [Pa].
  double strain = 0.0;        ///< Largest longitudinal strain magnitude at the outer fibre.
};

/// Lame for hoop and radial stress; von Mises at the extreme fibres of outer and inner wall.
///
/// Steel that yields: the strain is that of the curvature about the neutral axis, which has moved by what the largest
/// curvature so far asks for. The stress of a fibre is the elastic one of the moment, but not more than the
/// stress-strain curve bears at that largest curvature: right while the load grows, and the elastic change after it.
/// Stresses locked into the wall by yielding are not followed. Where only moments are known the elastic stress of the
/// moment stands.
SectionStress section_stress(const Section& section, const SectionLoads& loads);

}  // namespace overbend
