/// Cross-section of the pipe: what follows from steel, coatings and joint pattern.
#pragma once

#include <optional>
#include <string>

#include "model/bending_law.h"
#include "model/description.h"

namespace overbend {

inline constexpr double kGravity = 9.80665;  ///< Standard gravity [m/s2]; turns weights into masses.

struct Section {
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

/// Section properties from the layers. EA and EI are of the steel alone; the field-joint infill replaces the outermost
/// coating over part of the joint ([silva2009] table 4); buoyancy acts on the outermost diameter.
/// `water_weight_density` [N/m3].
Section derive_section(const std::string& name, const SectionDescription& description, double water_weight_density);

}  // namespace overbend
