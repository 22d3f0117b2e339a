/// Contact stiffness between pipe and roller: springs in series of pipe shell, coating and roller structure.
#pragma once

#include "model/pipe/section.h"

namespace overbend {

/// Default stiffness of a roller with its bearings and box [N/m]: half a millimetre under 25 kN.
inline constexpr double kRollerStructure = 50e6;

/// Parts of a contact's stiffness; 0 means a rigid part.
struct ContactStiffness {
  double shell = 0.0;      ///< Pipe wall, flattened by the roller [N/m].
  double coating = 0.0;    ///< [N/m]
  double structure = 0.0;  ///< Roller, its bearings and its box [N/m].

  /// Returns the stiffness of the parts in series; 0 if all are rigid [N/m].
  double total() const;
};

/// Length on which a roller bears on the coating [m]: along the roller, across the pipe, the chord of the coating that
/// just touches the steel, but not more than the roller's face. 0 for a pipe without coating.
///
///        ___---___
///     .-----------.   <- chord       roller below or at the side, axis along the chord
///    /  .-steel-.  \.
///
double contact_length(double roller_face, double outer_diameter, double steel_diameter);

/// Radial deflection of an endless cylindrical shell under a radial load of shape cos(n theta) cos(lambda x/R) and unit
/// pressure, by the equation of Morley (1959) [m/Pa]. R is the radius of the wall's middle, D = E t^3/(12 (1 - nu^2)):
///
///     w = a^2 / (D/R^4 a^2 (a - 1)^2 + E t/R^2 lambda^4),     a = lambda^2 + n^2
struct Shell {
  double radius = 0.0, thickness = 0.0;  ///< [m]
  double youngs_modulus = 0.0;           ///< [Pa]
  double poissons_ratio = 0.0;

  double response(double n, double lambda) const;
};

/// Radial stiffness of a long shell under a load on one line across it, over `bearing` [m] of its circumference [N/m]:
/// the sum of `Shell::response` over all wave numbers of a load P, without n = 0 and n = 1, which do not flatten the
/// section (the second is the bending of the pipe as a beam, which the rod has).
double shell_stiffness(const Shell& shell, double bearing);

/// Returns the contact stiffness of a roller of `face` [m] on a pipe. The coating layers are loaded over
/// `contact_length` across and over their thickness along the pipe (load spread at 45 deg); layers without a modulus
/// are rigid. `structure` [N/m].
ContactStiffness contact_stiffness(const Section& pipe, const SectionDescription& layers, double face,
                                   double structure);

}  // namespace overbend
