/// Rigid body that moves under its loads: six unknowns shared by all lines that touch it.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "hull/hull.h"
#include "mechanics/hinge.h"
#include "mechanics/hinge_law.h"
#include "mechanics/stinger_section.h"
#include "system/weights.h"

namespace overbend {

/// Energies and powers of a body without lines and rollers.
struct BodyEnergy {
  double kinetic = 0.0, stored = 0.0;  ///< [J]
  double power = 0.0;                  ///< Power of all environmental loads on it: waves, water, wind [W].
};

/// Force on a point of a body as a function of its position.
struct PlaceForce {
  Vec3 force = Vec3::Zero();      ///< On the body, W [N].
  Mat3 stiffness = Mat3::Zero();  ///< -d force / d place [N/m].
  double energy = 0.0;            ///< Potential energy of the force [J]; 0 if there is none.
  LineEndForces ends;             ///< End forces of a line: initial values for the next solution.
};

/// Massless line between the world and a body (quasi-static), or a spring: its end follows the body instantly. Must not
/// allocate.
struct BodySpring {
  Vec3 place_V = Vec3::Zero();  ///< Attachment point on the body [m].
  /// `near`: forces on the ends at the start of the step.
  std::function<PlaceForce(const Vec3& place, double time, const LineEndForces& near)> force;
  bool has_energy = true;  ///< False (friction, a winch): its work on the body is external.
};

/// Index of the only free coordinate of a hinged body, its angle. The others are constant.
inline constexpr int kHingeFreedom = 4;

/// A stinger section on its hinge.
struct HingedBody {
  int carrier = 0;  ///< Index of the body that carries the hinge: the vessel, or the previous section.
  Hinge hinge;
  HingeLaw law;
  bool held = false;  ///< The vessel holds its angle.
  SectionBody section;
  std::shared_ptr<const SectionSea> sea;
};

/// Data of a free body: the coordinates of hull/body_kinematics.h are unknowns. Its functions are called in the time
/// loop and must not allocate.
struct FreeBody {
  Vec3 reference_V = Vec3::Zero();  ///< Point whose position is unknown: the centre of gravity [m].
  Vec6 origin = Vec6::Zero();       ///< Coordinates from which surge, sway, heave, roll, pitch and yaw are counted.
  double force_scale = 1.0;         ///< Reference for residual forces [N].
  double arm = 1.0;                 ///< Reference length for moments and angles: half the length [m].
  Vec6 inertia = Vec6::Ones();      ///< Mass and moments of inertia with added mass, for the error estimate.
  std::vector<BodySpring> springs;  ///< Quasi-static lines.
  HullState rest;                   ///< State at rest, with memories of the right sizes.
  std::optional<HingedBody> hinge;  ///< Hinge of a hinged body: only its angle is free.
  std::array<bool, 6> held{};       ///< Coordinates that are kept constant.

  /// Balance of the body alone, as balance_hull().
  std::function<void(const HullState& state, const HullState& before, const Weights& weights, double time,
                     HullBalance& out)>
      balance;
  /// Moves the memories of `state` to the end of the step that began at `before`; may be empty.
  std::function<void(const HullState& before, double step, HullState& state)> finish_step;
  /// `step`: its last balance. May be empty.
  std::function<BodyEnergy(const HullState& state, double time, const HullBalance& step)> energy;
};

/// Returns a hull with all loads on it. `hull` must outlive the result. The force scale is the weight of the lines it
/// holds, but at least a thousandth of its own weight; `length` [m].
FreeBody free_hull(const Hull& hull, double line_weight, double length);

/// Returns a massless point at which lines and wires meet: in equilibrium their forces balance, relative to
/// `force_scale` [N]. It does not rotate.
FreeBody free_point(const Vec3& place, double force_scale);

/// Adds the contributions of a body's springs to its balance at a time: J^T force, with an exact tangent as far as the
/// spring's is. `state.lines` receives the line forces, found from those of `before`.
void add_springs(const FreeBody& body, const HullState& before, double time, HullState& state, HullBalance& out);

/// Returns the energy stored in the springs and the power of those that store none.
BodyEnergy spring_energy(const FreeBody& body, const HullState& state, double time);

/// Returns the rigid motion of V's origin.
RigidMotion rigid_motion(const FreeBody& body, const HullState& state);

/// Returns the derivative of a body-fixed point at `r` (W) by the coordinates.
Mat36 point_rows(const BodyPose& pose, const Vec3& r);
/// Returns the derivative of a body-fixed vector by the coordinates.
Mat36 vector_rows(const BodyPose& pose, const Vec3& t);

}  // namespace overbend
