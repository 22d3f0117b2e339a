/// Constants of the elements of a line and of what surrounds it, as the element kernel reads them.
#pragma once

#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "base/vec.h"
#include "mechanics/line_kernel.h"
#include "model/lay_route.h"
#include "model/model.h"

namespace overbend {

/// Element constants, one array per quantity; padded to whole batches of eight. Padding elements have no stiffness and
/// no load.
struct LineElements {
  int count = 0;
  AlignedDoubles length;             ///< Unstressed [m].
  AlignedDoubles EA, EI;             ///< [N], [N m2]
  AlignedDoubles compression;        ///< Share of EA that bears compression, see slack_law.h [-].
  AlignedDoubles damping;            ///< Internal, of what bears none: a time, see slack_law.h [s].
  AlignedDoubles weight;             ///< In air, with contents [N/m].
  AlignedDoubles buoyancy;           ///< Fully submerged [N/m].
  AlignedDoubles radius;             ///< Over the coatings [m].
  AlignedDoubles drag_normal;        ///< rho/2 Cd_n D [kg/m2]
  AlignedDoubles drag_axial;         ///< rho/2 pi D Cd_t [kg/m2]
  AlignedDoubles pressure_constant;  ///< Effective tension of pressure and Poisson's ratio: constant part [N],
  AlignedDoubles pressure_slope;     ///< part in z, from contents [N/m],
  AlignedDoubles pressure_external;  ///< part in depth, from the water [N/m].
  AlignedDoubles mass;               ///< With coatings and contents [kg/m].
  AlignedDoubles displaced_mass;     ///< Of the water that the pipe displaces [kg/m].
  AlignedDoubles added_normal;       ///< Added mass across the pipe, fully submerged [kg/m].
  AlignedDoubles added_axial;        ///< Along the pipe [kg/m].
  /// Friction of a line dragged along the bed: force along it, positive away from the vessel, per normal force [-].
  AlignedDoubles drag_on_bed;

  std::size_t padded() const { return length.size(); }

  LineView view() const;
};

/// Fills the constants of elements of the given lengths and sections.
LineElements line_elements(const Model& model, const std::vector<double>& lengths, const std::vector<int>& sections);

/// The surroundings of a line laid along a route. Points into `model` and to the pieces of a
/// route that bends, which must outlive it.
LineEnvironment line_environment(const Model& model, const LayRoute& route);

/// A bed's shape, if it has one, into what surrounds a line.
void set_shape(LineEnvironment& env, const BedSurface& bed);

/// Immersed fraction of a circular section with its centre at height z above the surface, and its derivative in z: the
/// exact circular segment.
struct WettedFraction {
  double value, slope;
};
WettedFraction wetted_fraction(double z, double radius);

/// Internal minus external forces of all elements (six per node) and, where `target` has blocks, their exact
/// derivative.
void add_line_forces(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                     const LineTarget& target, Isa isa);

/// The same in motion: inertia, Morison's forces of waves and current on the moving pipe, damping and Coulomb friction
/// of the bed with return mapping. The derivative is the total one in the unknowns: velocities and accelerations
/// follow them by the shares given in `motion`.
void add_line_forces(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                     const LineMotion& motion, const LineTarget& target, Isa isa);

/// Energies and powers alone, at an instant: the friction of the bed is stretched by `motion.bed_slip`.
LineEnergy line_energy(const LineElements& elements, const LineEnvironment& env, const LineShape& shape,
                       const LineMotion& motion, Isa isa);

}  // namespace overbend
