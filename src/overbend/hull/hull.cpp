#include "hull/hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr double kSteepest = 60.0 / 180.0 * std::numbers::pi;

/// Transformation of vectors from H to W: translations rotate with the low-frequency heading, rates of the angles do
/// not.
Mat6 heading_transform(const SlowMotion& slow) {
  Mat6 T = Mat6::Identity();
  T.topLeftCorner<3, 3>() = turned_about_z(slow.value.z());
  return T;
}

Vec6 rates_in_h(const SlowMotion& slow, const Vec6& v) {
  Vec6 in_h = v;
  in_h.head<3>() = turned_about_z(-slow.value.z()) * v.head<3>();
  return in_h;
}

/// Cross product with a rotation rate about z, on both halves of a six-vector.
Mat6 rate_matrix(double r) {
  Mat6 Z = Mat6::Zero();
  Z(0, 1) = Z(3, 4) = -r;
  Z(1, 0) = Z(4, 3) = r;
  return Z;
}

/// Force of the added mass in rotating axes in addition to A times the acceleration: from the momentum A v, which
/// rotates with rate r, minus the contribution of H's own rotation to the acceleration. Matrix on v.
Mat6 turning_matrix(const Mat6& A, double r) {
  const Mat6 Z = rate_matrix(r);
  Mat6 turning = Z * A;
  turning.leftCols<3>() -= A.leftCols<3>() * Z.topLeftCorner<3, 3>();
  return turning;
}

// Loads at the low-frequency position and heading, in H --------------------------------------------------------------

Vec6 station_force(const StationKeeping& keeping, const SlowMotion& slow, double time) {
  const Vec3 thrust = station_thrust(keeping, slow, time).given;
  return (Vec6() << thrust.x(), thrust.y(), 0.0, 0.0, 0.0, thrust.z()).finished();
}

/// Rates of the low-frequency motion in its horizontal axes.
Vec6 slow_rates_in_h(const SlowMotion& slow) {
  const Vec3 rate = turned_about_z(-slow.value.z()) * slow.rate;
  return (Vec6() << rate.x(), rate.y(), 0.0, 0.0, 0.0, rate.z()).finished();
}

/// Munk moment of the steady drift through the water.
double munk_moment(const Hull& hull, const SlowMotion& slow) {
  const Vec3 drift = slow.rate - Vec3(hull.current.velocity.x(), hull.current.velocity.y(), 0.0);
  const Vec3 in_h = turned_about_z(-slow.value.z()) * drift;
  return -hull.munk * in_h.x() * in_h.y();
}

StripWater water_at_strips(const Hull& hull, const SlowMotion& slow, double time, double share) {
  StripWater water;
  const HullCurrent& c = hull.current;
  if (share == 0.0 || !by_strips(c) || !c.in_water) return water;
  const double first = strip_place(c, 0) - c.reference_V.x(), spacing = c.length / kHullStrips;
  water = strip_water(hull.waves, time, slow.value, first, spacing);
  for (double& u : water.along) u *= share;
  for (double& u : water.across) u *= share;
  return water;
}

HullEnvironment make_environment(const Hull& hull, const SlowMotion& slow, double time) {
  HullEnvironment s;
  s.time = time;
  s.slow = slow;
  s.built_up = time == kBeforeWaves ? 0.0 : half_cosine(time, hull.build_up).value;
  if (!hull.waves.empty() && (s.built_up > 0.0 || hull.mean_drift_from_start)) {
    const WaveForce f = wave_force(hull.waves, s.built_up > 0.0 ? time : 0.0, slow.value);
    s.waves = s.built_up * f.first_order;
    s.drift = hull.mean_drift_from_start ? Vec6(f.mean_drift + s.built_up * (f.drift - f.mean_drift))
                                         : Vec6(s.built_up * f.drift);
  }
  s.water = water_at_strips(hull, slow, time, s.built_up);
  s.munk = munk_moment(hull, slow);
  s.wind = wind_force(hull.wind, slow.value.z());
  if (hull.station_keeping) s.station = station_force(*hull.station_keeping, slow, time);
  return s;
}

/// Environment at the end of a step, with the hull's motion extrapolated from its start.
HullEnvironment make_environment_after(const Hull& hull, const HullState& before, double step, double time) {
  const Vec6 moved_h = before.h + step * before.v;
  HullEnvironment s =
      make_environment(hull, slow_motion_after(before.slow, before.h, moved_h, step, hull.low_frequency_period), time);
  const Vec6 v = rates_in_h(before.slow, before.v);
  if (step > 0.0) {
    s.memory = radiation_step(hull.radiation, before.radiation, v, step);
  } else {
    s.memory.force_at_rest_end = radiation_force(hull.radiation, before.radiation, v);
  }
  return s;
}

/// Environmental loads on a hull that moves with `v`, in H.
struct EnvironmentalForce {
  Vec6 drift = Vec6::Zero();
  CurrentForce current;
  Vec6 sum = Vec6::Zero();   ///< Including those independent of `v`.
  Mat6 by_v = Mat6::Zero();  ///< Derivative of the sum.
};

EnvironmentalForce environmental_force(const Hull& hull, const HullEnvironment& around, const Vec6& v) {
  EnvironmentalForce f;
  f.drift = around.drift - around.built_up * (hull.drift_damping * v);
  if (hull.current.form == HullCurrentModel::table) {
    // Tables are for steady flow past a hull: no damping of wave-frequency motions.
    f.current = current_force(hull.current, around.slow.value.z(), slow_rates_in_h(around.slow), around.water);
    f.current.by_v.setZero();
  } else {
    f.current = current_force(hull.current, around.slow.value.z(), v, around.water);
  }
  f.current.force(5) += around.munk;
  f.sum = around.waves + f.drift + around.wind + around.station + f.current.force;
  f.by_v = f.current.by_v - around.built_up * hull.drift_damping;
  return f;
}

/// In statics all of these follow the hull: derivatives by x, y and psi.
void add_slopes_at_rest(const Hull& hull, const SlowMotion& slow, double time, Mat6& tangent) {
  const auto force = [&](const SlowMotion& shifted) -> Vec6 {
    return heading_transform(shifted) *
           environmental_force(hull, make_environment(hull, shifted, time), Vec6::Zero()).sum;
  };
  const int columns[3] = {0, 1, 5};
  for (int k = 0; k < 3; ++k) {
    const double d = k < 2 ? 1e-3 : 1e-5;  // forces change over metres and degrees; exact for linear terms
    SlowMotion ahead = slow, behind = slow;
    ahead.value(k) += d;
    behind.value(k) -= d;
    tangent.col(columns[k]) -= (force(ahead) - force(behind)) / (2.0 * d);
  }
}

// Loads from the hull's own motion -----------------------------------------------------------------------------------

/// Force on the water in H with its derivatives by v and acc there.
struct Reaction {
  Vec6 force = Vec6::Zero();
  Mat6 by_v = Mat6::Zero();
};

Reaction added_mass(const Hull& hull, const SlowMotion& slow, const Vec6& v, const Vec6& acc) {
  Reaction r;
  r.by_v = turning_matrix(hull.radiation.added_mass, slow.rate.z());
  r.force = hull.radiation.added_mass * acc + r.by_v * v;
  return r;
}

Reaction viscous(const ViscousDamping& damping, const Vec6& v) {
  Reaction r;
  r.by_v = damping.linear;
  r.by_v.diagonal() += 2.0 * damping.quadratic.cwiseProduct(v.cwiseAbs());
  r.force = damping.linear * v + damping.quadratic.cwiseProduct(v.cwiseAbs()).cwiseProduct(v);
  return r;
}

/// Loads that rotate with the body or are constant in W: loads and ballast.
void add_loads(const Hull& hull, const Vec6& h, double stiffness, HullBalance& out) {
  out.residual -= hull.ballast;
  if (hull.loads.empty()) return;
  const BodyPose pose = make_pose(h);
  for (const HullLoad& load : hull.loads) {
    const Vec3 arm = pose.R * load.arm;
    out.residual -= generalised_force(pose, arm, load.force_W) + generalised_moment(pose, load.moment_W);
    out.tangent -=
        stiffness * (generalised_force_slope(pose, arm, load.force_W) + generalised_moment_slope(pose, load.moment_W));
  }
}

}  // namespace

StationThrust station_thrust(const StationKeeping& keeping, const SlowMotion& slow, double time) {
  const Mat3 to_h = turned_about_z(-slow.value.z());
  const MoveState way_point = keeping.move ? keeping.move->at(time) : MoveState{};
  const Vec3 ahead(keeping.ahead_W.x(), keeping.ahead_W.y(), 0.0);
  const Vec3 off = to_h * (keeping.wanted + way_point.distance * ahead - slow.value),
             rate = to_h * (slow.rate - way_point.speed * ahead);
  const Vec3 asked = keeping.law.stiffness.cwiseProduct(off) - keeping.law.damping.cwiseProduct(rate);
  return {asked, asked.cwiseMax(-keeping.law.limit).cwiseMin(keeping.law.limit)};
}

HullState make_static_hull(const Hull& hull, const Vec6& h) {
  HullState state;
  state.h = h;
  state.radiation = make_bending_memory(hull.radiation);
  state.slow = slow_motion_at_rest(h);
  return state;
}

void balance_hull(const Hull& hull, const HullState& state, const HullState& before, double step,
                  const HullWeights& weights, double time, HullBalance& out) {
  const bool at_rest = weights.damping == 0.0 && weights.mass == 0.0, in_step = !at_rest && step > 0.0;
  HullEnvironment local;  // for this evaluation only
  if (at_rest) {
    local = make_environment(hull, slow_motion_at_rest(state.h), time);
  } else if (!in_step) {
    local = make_environment_after(hull, before, step, time);
  } else if (!out.surroundings) {
    out.surroundings = make_environment_after(hull, before, step, time);
  }
  const HullEnvironment& around = in_step ? *out.surroundings : local;
  const Mat6 T = heading_transform(around.slow);
  const Vec6 v = T.transpose() * state.v, acc = T.transpose() * state.acc;

  const RigidBodyForce inertia = rigid_body_force(hull.body, state.h, state.v, state.acc);
  out.residual = inertia.force + hull.hydrostatics * (state.h - hull.drawn);
  out.tangent = weights.stiffness * (inertia.by_h + hull.hydrostatics) + weights.damping * inertia.by_v +
                weights.mass * inertia.by_a;

  const Reaction mass = added_mass(hull, around.slow, v, acc), losses = viscous(hull.damping, v);
  const EnvironmentalForce outside = environmental_force(hull, around, v);
  const RadiationStep& memory = around.memory;
  out.residual += T * (mass.force + memory.force_at_rest_end + memory.slope * v + losses.force - outside.sum);
  const Mat6 by_v = mass.by_v + memory.slope + losses.by_v - outside.by_v;
  out.tangent += T * (weights.damping * by_v + weights.mass * hull.radiation.added_mass) * T.transpose();

  add_loads(hull, state.h, weights.stiffness, out);
  if (at_rest) {
    Mat6 slopes = Mat6::Zero();
    add_slopes_at_rest(hull, around.slow, time, slopes);
    out.tangent += weights.stiffness * slopes;
  }
}

void finish_step(const Hull& hull, const HullState& before, double step, HullState& state) {
  state.slow = slow_motion_after(before.slow, before.h, state.h, step, hull.low_frequency_period);
  state.radiation.values = before.radiation.values;
  advance(hull.radiation, state.radiation, rates_in_h(before.slow, before.v), rates_in_h(state.slow, state.v), step);
}

SteadyForces steady_forces(const Hull& hull, double psi) {
  SlowMotion slow;
  slow.value.z() = psi;
  const HullEnvironment around = make_environment(hull, slow, kBeforeWaves);
  return {environmental_force(hull, around, Vec6::Zero()).current.force, around.wind, around.drift};
}

const char* hull_limit_message(const HullState& state) {
  if (!state.h.allFinite() || !state.v.allFinite() || !state.acc.allFinite()) return "the hull's motion is not finite";
  if (std::abs(state.h(4)) > kSteepest) return "the hull pitches beyond 60 deg";
  return nullptr;
}

HullEnergy hull_energy(const Hull& hull, const HullState& state, double time,
                       const std::optional<HullEnvironment>& of_step) {
  HullEnergy e;
  const Vec6 v = rates_in_h(state.slow, state.v), off = state.h - hull.drawn;
  const bool at_hand = of_step && of_step->time == time;
  const HullEnvironment around = at_hand ? *of_step : make_environment(hull, state.slow, time);
  const EnvironmentalForce outside = environmental_force(hull, around, v);
  e.kinetic = kinetic_energy(hull.body, state.h, state.v) + 0.5 * v.dot(hull.radiation.added_mass * v);
  e.hydrostatic = 0.5 * off.dot(hull.hydrostatics * off);
  e.radiation = -v.dot(radiation_force(hull.radiation, state.radiation, v));
  e.waves = v.dot(around.waves);
  e.drift = v.dot(outside.drift);
  e.current = v.dot(outside.current.force);
  e.wind = v.dot(around.wind);
  e.station_keeping = v.dot(around.station);
  e.turning = -v.dot(rate_matrix(state.slow.rate.z()) * (hull.radiation.added_mass * v));
  e.viscous = -v.dot(viscous(hull.damping, v).force);
  HullBalance loads;
  add_loads(hull, state.h, 0.0, loads);
  e.ballast = state.v.dot(hull.ballast);
  e.loads = -state.v.dot(loads.residual) - e.ballast;
  return e;
}

}  // namespace overbend
