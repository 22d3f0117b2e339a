/// A rigid body that moves as the forces on it ask: six unknowns, shared by all lines that touch it.
#pragma once

#include <functional>

#include "hull/hull.h"
#include "system/weights.h"

namespace overbend {

/// Energies and powers of a body by itself, without lines and rollers.
struct BodyEnergy {
  double kinetic = 0.0, stored = 0.0;  ///< [J]
  double power = 0.0;                  ///< Of all that surrounds it, on it: waves, water, wind [W].
};

/// What makes a body free: the coordinates of hull/body_kinematics.h are unknowns. Its functions are called in the time
/// loop and must not allocate.
struct FreeBody {
  Vec3 reference_V = Vec3::Zero();  ///< Point whose place is unknown: the centre of gravity [m].
  Vec6 drawn = Vec6::Zero();        ///< Coordinates that surge, sway, heave, roll, pitch and yaw are counted from.
  double force_scale = 1.0;         ///< What unbalanced forces are measured against [N].
  double arm = 1.0;                 ///< Moments and angles are measured by it: half the length [m].
  Vec6 inertia = Vec6::Ones();      ///< Mass and moments, with those of the water, for the estimate of errors.

  /// Balance of the body by itself, as balance_hull().
  std::function<void(const HullState& at, const HullState& before, const Weights& weights, double time,
                     HullBalance& out)>
      balance;
  /// Moves the memories of `at` to the end of the step that began at `before`; may be empty.
  std::function<void(const HullState& before, double step, HullState& at)> finish_step;
  std::function<BodyEnergy(const HullState& at, double time)> energy;  ///< May be empty.
};

/// Motion as a rigid body, of V's origin.
RigidMotion rigid_motion(const FreeBody& body, const HullState& at);

/// How a point at `r` (W) that goes with the body moves with its coordinates.
Mat36 point_rows(const BodyPose& pose, const Vec3& r);
/// How a vector that turns with the body does.
Mat36 vector_rows(const BodyPose& pose, const Vec3& t);

/// a x, as a matrix.
Mat3 cross_matrix(const Vec3& a);

}  // namespace overbend
