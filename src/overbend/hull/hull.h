/// The floating hull: what acts on it, and its equations of motion with their tangent.
///
///     residual = rigid body + added mass and radiation + hydrostatics - waves - drift - current - wind - damping
///                - loads - ballast - station keeping
///
/// six generalised forces conjugate to h (hull/body_kinematics.h); the reference point is the centre of gravity. What
/// lines, rollers and tensioner do to the hull is subtracted by who knows them. Exact rigid-body geometry; coefficients
/// of the hydrodynamics act in the horizontal axes H that stand at the slow heading psi_f. Theory: docs/theory/hull.md.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "hull/body_kinematics.h"
#include "hull/hull_current.h"
#include "hull/hull_waves.h"
#include "hull/hull_wind.h"
#include "hull/radiation.h"
#include "hull/rigid_body.h"
#include "hull/slow_motion.h"
#include "mechanics/move_profile.h"
#include "mechanics/sea.h"
#include "model/description/hull_description.h"

namespace overbend {

/// A load of the user: constant in W, its point moves with the hull.
struct HullLoad {
  Vec3 arm = Vec3::Zero();                               ///< From the reference point, axes of the body [m].
  Vec3 force_W = Vec3::Zero(), moment_W = Vec3::Zero();  ///< [N], [N m]
};

/// Dynamic positioning towards a place and heading, on the slow motion.
struct StationKeeping {
  Vec3 wanted = Vec3::Zero();                         ///< x, y, psi, before it moves ahead [m, m, rad].
  StationKeepingDescription law;                      ///< Surge, sway and yaw of the slow heading.
  std::optional<MoveProfile> move = std::nullopt;     ///< How the wanted place moves ahead, if it does.
  Eigen::Vector2d ahead_W = Eigen::Vector2d::Zero();  ///< Which way.
};

/// Ahead and to port along the slow heading, and bow to port [N, N, N m].
struct StationThrust {
  Vec3 asked = Vec3::Zero();  ///< By spring and damper.
  Vec3 given = Vec3::Zero();  ///< Within the limits.
};

/// What dynamic positioning does where the slow motion is `slow` at `time` [s].
StationThrust station_thrust(const StationKeeping& keeping, const SlowMotion& slow, double time);

/// Damping besides radiation, on the rates of H: F = -linear v - quadratic |v| v by component.
struct ViscousDamping {
  Mat6 linear = Mat6::Zero();     ///< [N s/m, N s, N m s]
  Vec6 quadratic = Vec6::Zero();  ///< [N s2/m2], [N m s2]
};

/// Made by make_hull; constant in an analysis.
struct Hull {  // NOLINT(clang-analyzer-optin.performance.Padding): there is one of it; in the order of subjects
  Vec3 reference_V = Vec3::Zero();  ///< Reference point in V: the centre of gravity [m].
  Vec6 drawn = Vec6::Zero();        ///< Coordinates with the hull as drawn, where its water balances its weight.
  Vec6 lies = Vec6::Zero();         ///< Coordinates where it lies in statics: of its heading in sea, current and wind.
  RigidBody body;
  Mat6 hydrostatics = Mat6::Zero();  ///< On the distance from `drawn`; heave, roll and pitch alone. [N/m, N, N m]
  RadiationModel radiation;
  HullWaves waves;
  HullCurrent current;
  HullWind wind;
  ViscousDamping damping;
  Mat6 drift_damping = Mat6::Zero();  ///< Of the waves' drift, in H [N s/m, N s].
  /// A22 - A11 at 0.1 rad/s for Munk's moment of the slow motion through the water; 0 where a table holds it [kg].
  double munk = 0.0;
  Vec6 ballast = Vec6::Zero();  ///< Constant generalised force that trims the hull: set by statics [N, N m].
  std::vector<HullLoad> loads;
  std::optional<StationKeeping> station_keeping;
  double slow_period = 40.0;           ///< Corner of the slow motion [s].
  double build_up = 0.0;               ///< Of the waves before t = 0 [s]; half a cosine.
  bool mean_drift_from_start = false;  ///< The mean of the drift acts in full before and during the build-up.

  /// Whether the water's memory and waves are known: false for a hull of given hydrostatics, which serves statics.
  bool in_waves() const { return !waves.empty(); }
};

/// Forces of a quasi-static line on its ends, in its vertical plane: the next ones are sought from them.
struct LineEndForces {
  double pull = 0.0, sink = 0.0;                  ///< On the hull: towards the anchor, downwards [N].
  double anchor_pull = 0.0, anchor_uplift = 0.0;  ///< On the anchor: towards the hull, upwards [N].
  double length = 0.0, on_bed = 0.0;              ///< Unstressed, of the whole and of what lies on the bed [m].
  double anchor_rise = 0.0;  ///< Vertical part of the tension at the anchor, also of a line that lies on a slope [N].

  double fairlead_tension() const { return std::hypot(pull, sink); }              ///< [N]
  double anchor_tension() const { return std::hypot(anchor_pull, anchor_rise); }  ///< Along the line [N].
};

/// Everything that the hull remembers. Copied it resumes bit for bit.
struct HullState {
  Vec6 h = Vec6::Zero(), v = Vec6::Zero();      ///< Coordinates and their rates.
  Vec6 acc = Vec6::Zero(), alg = Vec6::Zero();  ///< True and algorithmic acceleration.
  RadiationMemory radiation;
  SlowMotion slow;
  std::vector<LineEndForces> lines;  ///< Of the quasi-static lines on it.
  double hinge_slip = 0.0;           ///< Of a body on a hinge: elastic part of its friction [rad].
};

/// The hull at rest at h in water at rest.
HullState hull_at_rest(const Hull& hull, const Vec6& h);

/// Weights of the derivatives by h, v and acc in the tangent: changes of v and acc with the unknown.
struct HullWeights {
  double stiffness = 1.0, damping = 0.0, mass = 0.0;
};

/// What surrounds the hull at its slow place and heading, whatever it does there; forces in H [N, N m].
struct HullSurroundings {
  double time = 0.0;  ///< [s]
  SlowMotion slow;
  double built_up = 0.0;  ///< Share of the waves that is there.
  Vec6 waves = Vec6::Zero(), drift = Vec6::Zero(), wind = Vec6::Zero(), station = Vec6::Zero();
  double munk = 0.0;     ///< Moment of the slow motion through the water [N m].
  StripWater water;      ///< Of the waves at the hull's strips.
  RadiationStep memory;  ///< Of the waves that the hull has radiated.
};

struct HullBalance {
  Vec6 residual = Vec6::Zero();
  Mat6 tangent = Mat6::Zero();
  /// Those of the step under way: found by its first evaluation. To be emptied where another step begins.
  std::optional<HullSurroundings> surroundings;
};

/// Time that stands for statics: before all waves.
inline constexpr double kBeforeWaves = -std::numeric_limits<double>::infinity();

/// Residual and tangent at the state `at` (h, v and acc; its memories are not looked at), which ends a step of length
/// `step` [s] from the state `before`. Forces at the slow place see it go on as it did at the start of the step: they
/// miss (w_f step)^2 of what accelerations move the hull by in one, and the tangent is exact.
///
/// `step` 0: `at` stands where `before` stands; the memories of `before` are as they are. Weights (1, 0, 0) stand for
/// statics: the slow motion is then that of h, and its influence is in the tangent; rates should be zero and `time`
/// kBeforeWaves. Does not allocate.
void balance_hull(const Hull& hull, const HullState& at, const HullState& before, double step,
                  const HullWeights& weights, double time, HullBalance& out);

/// Moves the memories of `at` (water, slow motion) from those of `before` to the end of the step. Does not allocate
/// when `at` was copied from `before` once.
void finish_step(const Hull& hull, const HullState& before, double step, HullState& at);

/// What acts on the hull at rest beside water at rest, lines and loads, about the reference point in H. [N, N m]
struct SteadyForces {
  Vec6 current = Vec6::Zero();  ///< With Munk's moment.
  Vec6 wind = Vec6::Zero();
  Vec6 drift = Vec6::Zero();  ///< Mean, where `mean_drift_from_start`.

  Vec6 sum() const { return current + wind + drift; }
};

/// The steady part of what balance_hull lets act before the waves, with the hull heading psi [rad]. Does not allocate.
SteadyForces steady_forces(const Hull& hull, double psi);

/// Why the state is beyond what the equations are good for, or nullptr: pitch beyond 60 deg, not finite.
const char* hull_refusal(const HullState& state);

/// What flows into the hull's motion by each cause [W], and what it holds [J].
struct HullEnergy {
  double kinetic = 0.0;      ///< Of the rigid body and A_inf.
  double hydrostatic = 0.0;  ///< Of `hydrostatics` from the drawn pose.
  double radiation = 0.0, waves = 0.0, drift = 0.0, current = 0.0, wind = 0.0, viscous = 0.0, loads = 0.0,
         ballast = 0.0, station_keeping = 0.0;  ///< Powers into the hull.
  /// Of the turning terms of A_inf: Munk's moment, which would give it back to yaw, is not among the forces of waves.
  double turning = 0.0;
  double power() const {
    return radiation + waves + drift + current + wind + viscous + loads + ballast + station_keeping + turning;
  }
};
/// `of_step`: the surroundings that the step which ended in `state` was balanced with, where they are at hand.
HullEnergy hull_energy(const Hull& hull, const HullState& state, double time,
                       const std::optional<HullSurroundings>& of_step = std::nullopt);

}  // namespace overbend
