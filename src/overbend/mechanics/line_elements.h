/// Constants of the elements of a line and of its environment in the memory layout of the element kernel.
#pragma once

#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "base/vec.h"
#include "mechanics/line_kernel.h"
#include "model/lay_route.h"
#include "model/model.h"

namespace overbend {

/// Element constants, one array per quantity, padded to whole batches of eight. Padding elements have no stiffness and
/// no load.
struct LineElements {
  int count = 0;
  AlignedDoubles length;             ///< Unstressed [m].
  AlignedDoubles EA, EI;             ///< [N], [N m2]
  AlignedDoubles compression;        ///< Fraction of EA effective in compression, see slack_law.h [-].
  AlignedDoubles damping;            ///< Internal damping of the tension-only part: a time, see slack_law.h [s].
  AlignedDoubles weight;             ///< In air, with contents [N/m].
  AlignedDoubles buoyancy;           ///< Fully submerged [N/m].
  AlignedDoubles radius;             ///< Outer radius including coatings [m].
  AlignedDoubles drag_normal;        ///< rho/2 Cd_n D [kg/m2]
  AlignedDoubles drag_axial;         ///< rho/2 pi D Cd_t [kg/m2]
  AlignedDoubles pressure_constant;  ///< Effective tension from pressure and Poisson's ratio: constant part [N],
  AlignedDoubles pressure_slope;     ///< part linear in z, from contents [N/m],
  AlignedDoubles pressure_external;  ///< part linear in depth, from the water [N/m].
  AlignedDoubles mass;               ///< With coatings and contents [kg/m].
  AlignedDoubles displaced_mass;     ///< Displaced mass of water [kg/m].
  AlignedDoubles added_normal;       ///< Added mass across the pipe, fully submerged [kg/m].
  AlignedDoubles added_axial;        ///< Along the pipe [kg/m].
  /// Friction of a line dragged along the seabed: axial force per normal force, positive away from the vessel [-].
  AlignedDoubles drag_on_bed;

  std::size_t padded() const { return length.size(); }

  /// Returns pointers to the arrays; valid as long as the arrays are unchanged.
  LineView view() const;
};

/// Makes the constants of elements of the given unstressed lengths [m] and section indices.
LineElements line_elements(const Model& model, const std::vector<double>& lengths, const std::vector<int>& sections);

/// Returns the environment of a line laid along a route. It points into `model` and to the pieces of a curved route,
/// which must outlive it.
LineEnvironment line_environment(const Model& model, const LayRoute& route);

/// Sets the bathymetry in the environment of a line; no effect for a plane seabed.
void set_shape(LineEnvironment& env, const SeabedSurface& bed);

/// Immersed fraction of a circular section of `radius` with its centre at height z above the surface [m], and its
/// derivative in z: the exact circular segment.
struct WettedFraction {
  double value, slope;
};
WettedFraction wetted_fraction(double z, double radius);

/// Adds internal minus external forces of all elements (six per node) and, where `target` has blocks, their exact
/// derivative.
void add_line_forces(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target, Isa isa);

/// Adds the forces of a moving line: inertia, Morison's forces of waves and current on the moving pipe, damping and
/// Coulomb friction of the seabed with return mapping. The derivative is the total one with the unknowns: velocities
/// and accelerations follow them by the factors given in `motion`.
void add_line_forces(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                     const LineMotion& motion, const LineTarget& target, Isa isa);

/// Returns energies and powers at an instant; `motion.bed_slip` is the elastic slip of the seabed friction.
LineEnergy line_energy(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                       const LineMotion& motion, Isa isa);

}  // namespace overbend
