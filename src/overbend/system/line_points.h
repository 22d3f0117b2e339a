/// Clump weights and buoys at nodes of a line: forces with exact derivatives, and energies.
///
/// A point moves with its node. Its weight, its buoyancy by the wetted share of a sphere or an upright cylinder, drag
/// on the relative velocity, added mass on the relative acceleration with the force of the accelerated water (Morison
/// et al. 1950; DNV-RP-C205 section 6), and the bed under it, which bears it and damps its approach.
///
/// At the end of a tether it stands over its node, a clump under it, however the line moves: what a buoy drifts
/// sideways on its tether is left out, the pull it gives is not. A tether does not push: a buoy that floats, or a clump
/// that lies, lets go of the line, its mass with it.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "mechanics/line_kernel.h"
#include "model/description/line_description.h"
#include "model/model.h"
#include "numerics/block_tridiagonal.h"

namespace overbend {

struct LinePoint {
  int node = 0;
  double weight = 0.0, buoyancy = 0.0;                        ///< In air; fully submerged [N].
  double mass = 0.0, displaced_mass = 0.0, added_mass = 0.0;  ///< [kg]
  double drag = 0.0;                                          ///< rho/2 C_d A [kg/m]
  BuoyShape shape = BuoyShape::sphere;
  double half_height = 1.0;    ///< Radius of a sphere, half the height of a cylinder [m].
  double tether = 0.0;         ///< How far it stands over its node; negative: it hangs; 0: fixed to the line [m].
  double bed_stiffness = 0.0;  ///< [N/m]
  double bed_damping = 0.0;    ///< On approach, in motion [N s/m].
};

/// At a node of a line, in the model's water. A point without mass has what its net force asks for.
LinePoint line_point(const Model& model, const LinePointDescription& description, int node);

/// What it pulls its node by at rest, W [N].
Vec3 point_force(const LinePoint& point, const LineEnvironment& env, const double* q);

/// Makes its forces so much of what they are.
void scale_forces(LinePoint& point, double factor);

/// Immersed share of the volume with its middle at height z over the surface, and its derivative in z [-], [1/m].
struct PointWetting {
  double share, slope;
};
PointWetting point_wetting(BuoyShape shape, double half_height, double z);

/// Adds minus the forces of the points to `residual` (six per node) and, unless null, their derivatives to the blocks.
/// `motion` with null velocities is rest.
void add_point_forces(std::span<const LinePoint> points, const LineEnvironment& env, const double* q,
                      const LineMotion& motion, double* residual, BlockTridiagonal* tangent);

/// Adds energies and powers of the points. What comes through a tether counts as the water's power.
void add_point_energy(std::span<const LinePoint> points, const LineEnvironment& env, const double* q,
                      const LineMotion& motion, LineEnergy& sum);

}  // namespace overbend
