/// Cross-section of the pipe: what follows from steel, coatings and joint pattern.
#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "base/constants.h"
#include "model/description/lay_operation.h"
#include "model/description/section_description.h"
#include "model/description/structure_description.h"
#include "model/pipe/bending_law.h"

namespace overbend {

/// What a stretch of the line is.
enum class SectionKind {
  pipe,
  head,       ///< Closes the pipe and takes the cable; bends and yields as pipe.
  cable,      ///< No bending stiffness but what keeps it defined where it is slack; no code checks.
  structure,  ///< Built into the pipe.
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
  double second_moment = 0.0;   ///< Of the steel [m4]
  double EA = 0.0;              ///< [N]
  double EI = 0.0;              ///< [N m2]
  double external_area = 0.0;   ///< Displaced area, over the coatings [m2].
  double pressure_area =
      0.0;  ///< Of the steel's outside diameter: where water pressure meets the wall, see stress.h [m2].
  double internal_area = 0.0;            ///< Bore [m2].
  double weight_in_air = 0.0;            ///< With coatings, field joints and contents [N/m].
  double weight_submerged = 0.0;         ///< [N/m]
  double contents_weight_density = 0.0;  ///< [N/m3]
  double internal_pressure = 0.0;        ///< At z = 0 [Pa].
  std::optional<BendingLaw> bending;     ///< Of steel that yields; absent for linear steel.
  double drag_normal = 0.0, drag_axial = 0.0, added_mass_normal = 0.0, added_mass_axial = 0.0;

  double outer_radius() const { return 0.5 * outer_diameter; }
  double mass() const { return weight_in_air / kGravity; }  ///< [kg/m]
};

/// Whether stresses where two sections meet are told as those of the lower one: of pipe beside what is built into it,
/// of two pipes the softer, which bends more; of two that are as stiff that of the lower grade, which bears less.
inline bool lower_is_told(const Section& lower, const Section& upper) {
  const auto has_wall = [](const Section& s) { return s.kind == SectionKind::pipe || s.kind == SectionKind::head; };
  if (!has_wall(lower)) return false;
  if (!has_wall(upper)) return upper.kind == SectionKind::structure;
  return lower.EI < upper.EI || (lower.EI == upper.EI && lower.yield_stress < upper.yield_stress);
}

/// What the code checks count inside at least: a vacuum where one is given; contents do not suck above the water [Pa].
inline double least_pressure_on_bore(const Section& section) {
  return std::min(section.internal_pressure, 0.0);
}
/// Internal pressure of the code checks at a height [Pa].
inline double pressure_on_bore(const Section& section, double z) {
  return std::max(section.internal_pressure - section.contents_weight_density * z, least_pressure_on_bore(section));
}

/// Section properties from the layers. EA and EI are of the steel alone; the field-joint infill replaces the outermost
/// coating over part of the joint ([silva2009] table 4); buoyancy acts on the outermost diameter.
/// `water_weight_density` [N/m3].
Section derive_section(const std::string& name, const SectionDescription& description, double water_weight_density);

/// A cable as a section of the line: lies on rollers and drags by its diameter, displaces what its two weights differ
/// by. Stresses are those of a bar of steel of its weight; they say nothing of a rope and are not checked.
Section cable_section(const CableDescription& cable, double water_weight_density);
/// A head with the stiffness of `described` and its own weight, even over its length.
Section head_section(const HeadDescription& head, const SectionDescription& described, double water_weight_density);

/// What is built into a pipe of the section `pipe`: its stiffness, weight and diameter where it has any of its own. Its
/// steel is taken as a ring of the pipe's steel diameter with that stiffness, linear; stresses in it say nothing of a
/// forging and are not checked.
Section structure_section(const StructureDescription& structure, const Section& pipe, double water_weight_density);

}  // namespace overbend
