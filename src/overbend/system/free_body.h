/// A rigid body that moves as the forces on it ask: six unknowns, shared by all lines that touch it.
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

/// Energies and powers of a body by itself, without lines and rollers.
struct BodyEnergy {
  double kinetic = 0.0, stored = 0.0;  ///< [J]
  double power = 0.0;                  ///< Of all that surrounds it, on it: waves, water, wind [W].
};

/// A force on a point of a body that follows from where the point is.
struct PlaceForce {
  Vec3 force = Vec3::Zero();      ///< On the body, W [N].
  Mat3 stiffness = Mat3::Zero();  ///< -d force / d place [N/m].
  double energy = 0.0;            ///< Whose gradient the force is, with minus [J]; 0 where there is none.
  LineEndForces ends;             ///< Of a line: what the next force is sought from.
};

/// A line without mass between the world and a body (quasi-static), or a spring: its end follows the body at once. Must
/// not allocate.
struct BodySpring {
  Vec3 place_V = Vec3::Zero();  ///< Where it is fixed to the body [m].
  /// `near`: the ends' forces at the beginning of the step.
  std::function<PlaceForce(const Vec3& place, double time, const LineEndForces& near)> force;
  bool has_energy = true;  ///< Else (friction, a winch) its work on the body comes from outside.
};

/// The one of six coordinates that a body on a hinge has: its angle. The others stand still.
inline constexpr int kHingeFreedom = 4;

/// A section of a stinger on its hinge.
struct HingedBody {
  int carrier = 0;  ///< Which body carries the hinge, by its index: the vessel, or the section before.
  Hinge hinge;
  HingeLaw law;
  bool held = false;  ///< The ship holds its angle.
  SectionBody section;
  std::shared_ptr<const SectionSea> sea;
};

/// What makes a body free: the coordinates of hull/body_kinematics.h are unknowns. Its functions are called in the time
/// loop and must not allocate.
struct FreeBody {
  Vec3 reference_V = Vec3::Zero();  ///< Point whose place is unknown: the centre of gravity [m].
  Vec6 origin = Vec6::Zero();       ///< Coordinates that surge, sway, heave, roll, pitch and yaw are counted from.
  double force_scale = 1.0;         ///< What unbalanced forces are measured against [N].
  double arm = 1.0;                 ///< Moments and angles are measured by it: half the length [m].
  Vec6 inertia = Vec6::Ones();      ///< Mass and moments, with those of the water, for the estimate of errors.
  std::vector<BodySpring> springs;  ///< Quasi-static lines.
  HullState rest;                   ///< There, its memories of their sizes.
  std::optional<HingedBody> hinge;  ///< Of a body that hangs on another: its angle alone is free.
  std::array<bool, 6> held{};       ///< Coordinates that stay as they are.

  /// Balance of the body by itself, as balance_hull().
  std::function<void(const HullState& at, const HullState& before, const Weights& weights, double time,
                     HullBalance& out)>
      balance;
  /// Moves the memories of `at` to the end of the step that began at `before`; may be empty.
  std::function<void(const HullState& before, double step, HullState& at)> finish_step;
  /// `step`: its last balance. May be empty.
  std::function<BodyEnergy(const HullState& at, double time, const HullBalance& step)> energy;
};

/// A hull with all that acts on it. `hull` must outlive what is returned. Forces are measured against the weight of the
/// lines it holds, but at least a thousandth of its own; `length` [m].
FreeBody free_hull(const Hull& hull, double line_weight, double length);

/// A point without mass where lines and wires meet: it rests where their forces balance, which are measured against
/// `force_scale` [N]. It does not turn.
FreeBody free_point(const Vec3& place, double force_scale);

/// Adds what a body's springs do to its balance at a time: J^T force, its tangent exact as far as the spring's is.
/// `at.lines` receives the forces of lines, sought from those of `before`.
void add_springs(const FreeBody& body, const HullState& before, double time, HullState& at, HullBalance& out);

/// Energy stored in the springs, and power of those that store none.
BodyEnergy spring_energy(const FreeBody& body, const HullState& at, double time);

/// Motion as a rigid body, of V's origin.
RigidMotion rigid_motion(const FreeBody& body, const HullState& at);

/// How a point at `r` (W) that goes with the body moves with its coordinates.
Mat36 point_rows(const BodyPose& pose, const Vec3& r);
/// How a vector that turns with the body does.
Mat36 vector_rows(const BodyPose& pose, const Vec3& t);

}  // namespace overbend
