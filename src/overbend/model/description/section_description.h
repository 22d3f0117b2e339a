/// Cross-section of the pipe as given: steel, coatings, joints, hydrodynamic coefficients.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace overbend {

/// Relation between moment and curvature. All laws except `linear` yield, unload elastically and harden kinematically.
enum class MaterialLaw { linear, moment_ramberg_osgood, ramberg_osgood, bilinear, stress_strain, moment_curvature };

/// Point of a user-defined curve: strain [-] and stress [Pa], or curvature [1/m] and moment [N m].
struct CurvePoint {
  double x = 0.0, y = 0.0;
};

struct MaterialDescription {
  MaterialLaw law = MaterialLaw::linear;
  std::optional<double> moment_coefficient;  ///< A of kappa/kappa_y = M/M_y + A (M/M_y)^B; fitted if not given.
  std::optional<double> moment_exponent;     ///< B of the same law.
  std::optional<double> hardening_exponent;  ///< n of strain = stress/E + plastic part (stress/SMYS)^n.
  double yield_strain = 0.005;               ///< Total strain at SMYS [-].
  double hardening_modulus = 0.0;            ///< Slope of `bilinear` beyond yield [Pa].
  std::vector<CurvePoint> stress_strain;     ///< From the origin, which is not listed.
  std::vector<CurvePoint> moment_curvature;  ///< From the origin, which is not listed.
};

struct SteelDescription {
  double outside_diameter = 0.0;           ///< [m]
  double wall_thickness = 0.0;             ///< [m]
  double youngs_modulus = 207e9;           ///< [Pa]
  double poissons_ratio = 0.3;             ///< [-]
  double yield_stress = 0.0;               ///< SMYS [Pa]
  std::optional<double> tensile_strength;  ///< SMTS [Pa]
  double weight_density = 77e3;            ///< [N/m3]
  MaterialDescription material = {};
  bool yield_assumed = false;  ///< True if the SMYS is not that of the pipe but an assumption.
};

struct CoatingDescription {
  std::string name;
  double thickness = 0.0;                     ///< [m]
  double weight_density = 0.0;                ///< [N/m3]
  std::optional<double> youngs_modulus = {};  ///< For contact with rollers; rigid if not given [Pa].
};

/// Pipe joint with uncoated ends, where infill replaces the outermost coating.
struct JointDescription {
  double length = 12.2;                ///< Length of a pipe joint [m].
  double field_joint = 0.0;            ///< Length without the outermost coating, per joint [m].
  double infill_weight_density = 0.0;  ///< [N/m3]
  double coated_stiffness = 1.0;       ///< EI between the field joints divided by that of the steel [-].
  /// Distance from the tensioner to the middle of the first field joint; half a joint if not given [m].
  std::optional<double> first = {};
  /// Strain at a field joint divided by that of the adjacent pipe [-]; 1 with a warning if not given.
  std::optional<double> strain_factor = {};
};

struct HydrodynamicsDescription {
  double drag_normal = 1.2;
  double drag_axial = 0.0;
  double added_mass_normal = 1.0;
  double added_mass_axial = 0.0;
};

/// Cross-section of a length of pipe: steel, coatings from the steel outwards, joint pattern, hydrodynamic
/// coefficients.
struct SectionDescription {
  SteelDescription steel;
  std::vector<CoatingDescription> coatings;
  std::optional<JointDescription> joint;
  HydrodynamicsDescription hydrodynamics;
  double contents_weight_density = 0.0;  ///< Contents of the pipe; 0 = empty [N/m3].
  double internal_pressure = 0.0;        ///< Pressure at z = 0 [Pa].
};

}  // namespace overbend
