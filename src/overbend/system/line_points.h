/// Clump weights and buoys at nodes of a line: forces with exact derivatives, and energies.
///
/// A point moves with its node. Loads: weight, buoyancy by the wetted share of a sphere or an upright cylinder, drag on
/// the relative velocity, added mass on the relative acceleration with the force of the accelerated water (Morison et
/// al. 1950; DNV-RP-C205 section 6), and the seabed, which supports it and damps its approach.
///
/// On a tether a buoy stays vertically above its node, a clump below it, for any motion of the line: the lateral drift
/// of a buoy on its tether is neglected, its pull is not. A tether carries no compression: a floating buoy or a
/// grounded clump is released from the line with its mass.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "mechanics/line_kernel.h"
#include "model/description/line_description.h"
#include "model/model.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

/// A point on a node of a line.
struct LinePoint {
  int node = 0;
  double weight = 0.0, buoyancy = 0.0;                        ///< In air; fully submerged [N].
  double mass = 0.0, displaced_mass = 0.0, added_mass = 0.0;  ///< [kg]
  double drag = 0.0;                                          ///< rho/2 C_d A [kg/m]
  BuoyShape shape = BuoyShape::sphere;
  double half_height = 1.0;    ///< Radius of a sphere, half the height of a cylinder [m].
  double tether = 0.0;         ///< Height above its node; negative: below it; 0: fixed to the line [m].
  double bed_stiffness = 0.0;  ///< [N/m]
  double bed_damping = 0.0;    ///< On approach, in motion [N s/m].
};

/// Returns a point at a node of a line, in the model's water. A point without mass gets a mass from its net force.
LinePoint line_point(const Model& model, const LinePointDescription& description, int node);

/// Returns its static force on the node, W [N].
Vec3 point_force(const LinePoint& point, const LineEnvironment& env, const double* q);

/// Multiplies its forces by a factor.
void scale_forces(LinePoint& point, double factor);

/// Immersed share of the volume with its middle at height z above the surface, and its derivative by z [-], [1/m].
struct PointWetting {
  double share, slope;
};
PointWetting point_wetting(BuoyShape shape, double half_height, double z);

/// Subtracts the forces of the points from `residual` (six per node) and, unless null, adds the derivatives to the
/// blocks. `motion` with null velocities is rest.
void add_point_forces(std::span<const LinePoint> points, const LineEnvironment& env, const double* q,
                      const LineMotion& motion, double* residual, BlockTridiagonal* tangent);

/// Adds energies and powers of the points. The force of a tether counts as power of the water.
void add_point_energy(std::span<const LinePoint> points, const LineEnvironment& env, const double* q,
                      const LineMotion& motion, LineEnergy& sum);

}  // namespace overbend
