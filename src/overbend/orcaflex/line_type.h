/// Line types of an OrcaFlex file.
#pragma once

#include <optional>
#include <string>

#include "orcaflex/object.h"
#include "orcaflex/unit_system.h"

namespace overbend::orcaflex {

/// A line type in SI units. `Homogeneous pipe` has steel and layers, `General` its stiffnesses and its mass as numbers.
struct LineType {
  std::string name;
  bool is_pipe = false;           ///< Homogeneous pipe.
  double outside_diameter = 0.0;  ///< Outside diameter of the steel, or of a General type.
  double inside_diameter = 0.0;
  double youngs_modulus = 0.0, poissons_ratio = 0.3, density = 0.0;  ///< Properties of the steel [Pa, -, kg/m^3].
  double coating = 0.0, coating_density = 0.0;                       ///< Thickness, density.
  double lining = 0.0, lining_density = 0.0;
  double mass = 0.0, axial_stiffness = 0.0, bending_stiffness = 0.0;  ///< Numbers of a General type [kg/m, N, N m^2].
  std::optional<double> yield_stress;                                 ///< DNVSTF101Fy or AllowableStress [Pa].
  std::optional<double> allowable_tension;                            ///< [N]
  std::optional<double> contact_diameter, drag_diameter;
  double drag_normal = 0.0, drag_axial = 0.0, added_mass_normal = 0.0, added_mass_axial = 0.0;
  double friction = 0.0;  ///< On the seabed, sideways.

  double diameter() const { return outside_diameter + 2.0 * coating; }  ///< With coating.
  double diameter_on_bed() const { return contact_diameter.value_or(diameter()); }
  /// Mass of contents of `contents_density` and of the lining [kg/m].
  double mass_inside(double contents_density) const;
  /// Mass without contents and lining [kg/m].
  double mass_of_wall() const;
  double area_inside() const;  ///< Within the wall, without the lining.
};

/// Reads a line type. Categories other than `General` and `Homogeneous pipe` are errors.
LineType read_line_type(const Object& object, const UnitSystemOfFile& units);

}  // namespace overbend::orcaflex
