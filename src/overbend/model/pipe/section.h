/// Cross-section of the pipe: properties derived from steel, coatings and joint pattern.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "base/constants.h"
#include "model/description/lay_operation_description.h"
#include "model/description/section_description.h"
#include "model/description/structure_description.h"
#include "model/pipe/bending_law.h"

namespace overbend {

/// Type of a length of the line.
enum class SectionKind {
  pipe,
  head,       ///< Closes the pipe and connects the cable; bends and yields as pipe.
  cable,      ///< Negligible bending stiffness, for definiteness when slack; no code checks.
  structure,  ///< In-line structure.
};

struct Section {
  SectionKind kind = SectionKind::pipe;
  std::string name;
  double steel_diameter = 0.0;  ///< [m]
  double wall_thickness = 0.0;  ///< [m]
  double outer_diameter = 0.0;  ///< Over the coatings; also the hydrodynamic diameter [m].
  double youngs_modulus = 0.0;  ///< [Pa]
  double poissons_ratio = 0.0;  ///< [-]
  double yield_stress = 0.0;    ///< [Pa]
  double steel_area = 0.0;      ///< [m2]
  double second_moment = 0.0;   ///< Second moment of area of the steel [m4].
  double EA = 0.0;              ///< [N]
  double EI = 0.0;              ///< [N m2]
  double external_area = 0.0;   ///< Displaced area, over the coatings [m2].
  double pressure_area =
      0.0;  ///< Area of the steel's outside diameter, on which external pressure acts, see stress.h [m2].
  double internal_area = 0.0;            ///< Bore [m2].
  double weight_in_air = 0.0;            ///< With coatings, field joints and contents [N/m].
  double weight_submerged = 0.0;         ///< [N/m]
  double contents_weight_density = 0.0;  ///< [N/m3]
  double internal_pressure = 0.0;        ///< At z = 0 [Pa].
  std::optional<BendingLaw> bending;     ///< Bending law of yielding steel; empty for linear steel.
  double drag_normal = 0.0, drag_axial = 0.0, added_mass_normal = 0.0, added_mass_axial = 0.0;

  double outer_radius() const { return 0.5 * outer_diameter; }
  double mass() const { return weight_in_air / kGravity; }  ///< [kg/m]
};

/// Returns true if stresses at the interface of two sections are reported for the lower one: pipe rather than an
/// in-line structure; of two pipes the softer, which bends more; at equal stiffness the lower grade.
inline bool reports_lower_section(const Section& lower, const Section& upper) {
  const auto has_wall = [](const Section& s) { return s.kind == SectionKind::pipe || s.kind == SectionKind::head; };
  if (!has_wall(lower)) return false;
  if (!has_wall(upper)) return upper.kind == SectionKind::structure;
  return lower.EI < upper.EI || (lower.EI == upper.EI && lower.yield_stress < upper.yield_stress);
}

/// Min. internal pressure of the code checks: negative only if a vacuum is given; contents cause no suction above the
/// water [Pa].
inline double min_pressure_on_bore(const Section& section) {
  return std::min(section.internal_pressure, 0.0);
}
/// Returns the internal pressure of the code checks at an elevation [Pa].
inline double pressure_on_bore(const Section& section, double z) {
  return std::max(section.internal_pressure - section.contents_weight_density * z, min_pressure_on_bore(section));
}

/// Returns section properties from the layers. EA and EI are those of the steel; the field-joint infill replaces the
/// outermost coating over part of the joint ([silva2009] table 4); buoyancy acts on the outermost diameter.
/// `water_weight_density` [N/m3].
Section derive_section(const std::string& name, const SectionDescription& description, double water_weight_density);

/// Returns a cable as a section of the line: its diameter is used for contact and drag, its displacement is the
/// difference of its two weights. Stresses are those of a steel bar of equal weight; they are meaningless for a rope
/// and not checked.
Section cable_section(const CableDescription& cable, double water_weight_density);
/// Returns a head with the stiffness of `described` and its own weight, distributed over its length.
Section head_section(const HeadDescription& head, const SectionDescription& described, double water_weight_density);

/// Returns an in-line structure in a pipe of section `pipe`: stiffness, weight and diameter are its own if given. Its
/// steel is a linear ring with the pipe's steel diameter and that stiffness; stresses in it do not apply to a forging
/// and are not checked.
Section structure_section(const StructureDescription& structure, const Section& pipe, double water_weight_density);

}  // namespace overbend
