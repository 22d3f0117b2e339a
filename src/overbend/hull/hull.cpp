#include "hull/hull.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace overbend {
namespace {

constexpr double kSteepest = 60.0 / 180.0 * std::numbers::pi;

/// Vectors of H in W: translations turn with the slow heading, rates of the angles stay.
Mat6 turn_of(const SlowMotion& slow) {
  Mat6 T = Mat6::Identity();
  T.topLeftCorner<3, 3>() = turned_about_z(slow.value.z());
  return T;
}

Vec6 rates_in_h(const SlowMotion& slow, const Vec6& v) {
  Vec6 in_h = v;
  in_h.head<3>() = turned_about_z(-slow.value.z()) * v.head<3>();
  return in_h;
}

/// Of a turning rate about z, on both halves of a six-vector.
Mat6 rate_matrix(double r) {
  Mat6 Z = Mat6::Zero();
  Z(0, 1) = Z(3, 4) = -r;
  Z(1, 0) = Z(4, 3) = r;
  return Z;
}

/// Force of the added mass in turning axes beside A times the acceleration: of the momentum A v, which turns with rate
/// r, less what H's own turning takes from the acceleration. Its matrix on v.
Mat6 turning_of(const Mat6& A, double r) {
  const Mat6 Z = rate_matrix(r);
  Mat6 turning = Z * A;
  turning.leftCols<3>() -= A.leftCols<3>() * Z.topLeftCorner<3, 3>();
  return turning;
}

// What acts at the slow place and heading, in H ----------------------------------------------------------------------

Vec6 station_force(const StationKeeping& keeping, const SlowMotion& slow, double time) {
  const Vec3 thrust = station_thrust(keeping, slow, time).given;
  return (Vec6() << thrust.x(), thrust.y(), 0.0, 0.0, 0.0, thrust.z()).finished();
}

/// Rates of the slow motion in its horizontal axes.
Vec6 slow_rates_in_h(const SlowMotion& slow) {
  const Vec3 rate = turned_about_z(-slow.value.z()) * slow.rate;
  return (Vec6() << rate.x(), rate.y(), 0.0, 0.0, 0.0, rate.z()).finished();
}

/// Munk's moment of the steady drift through the water.
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

HullSurroundings surroundings_at(const Hull& hull, const SlowMotion& slow, double time) {
  HullSurroundings s;
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

/// Surroundings at the end of a step, in which the hull goes on as it began.
HullSurroundings surroundings_after(const Hull& hull, const HullState& before, double step, double time) {
  const Vec6 there = before.h + step * before.v;
  HullSurroundings s =
      surroundings_at(hull, slow_motion_after(before.slow, before.h, there, step, hull.slow_period), time);
  const Vec6 v = rates_in_h(before.slow, before.v);
  if (step > 0.0) {
    s.memory = radiation_step(hull.radiation, before.radiation, v, step);
  } else {
    s.memory.force_at_rest_end = radiation_force(hull.radiation, before.radiation, v);
  }
  return s;
}

/// Forces of the surroundings on a hull that moves with `v`, in H.
struct OutsideForce {
  Vec6 drift = Vec6::Zero();
  CurrentForce current;
  Vec6 sum = Vec6::Zero();   ///< Those that do not hang on `v` included.
  Mat6 by_v = Mat6::Zero();  ///< Of the sum.
};

OutsideForce outside_force(const Hull& hull, const HullSurroundings& around, const Vec6& v) {
  OutsideForce f;
  f.drift = around.drift - around.built_up * (hull.drift_damping * v);
  if (hull.current.form == HullCurrentForm::table) {
    // Tables are of steady flow past a hull: one that follows the waves is not damped by them.
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

/// At rest all of these follow the hull: their derivatives by x, y and psi.
void add_slopes_at_rest(const Hull& hull, const SlowMotion& slow, double time, Mat6& tangent) {
  const auto force = [&](const SlowMotion& at) -> Vec6 {
    return turn_of(at) * outside_force(hull, surroundings_at(hull, at, time), Vec6::Zero()).sum;
  };
  const int columns[3] = {0, 1, 5};
  for (int k = 0; k < 3; ++k) {
    const double d = k < 2 ? 1e-3 : 1e-5;  // forces change over metres and degrees; exact for what is linear
    SlowMotion ahead = slow, behind = slow;
    ahead.value(k) += d;
    behind.value(k) -= d;
    tangent.col(columns[k]) -= (force(ahead) - force(behind)) / (2.0 * d);
  }
}

// What the hull itself does to the water -----------------------------------------------------------------------------

/// Force on the water in H with its derivatives by v and acc there.
struct Reaction {
  Vec6 force = Vec6::Zero();
  Mat6 by_v = Mat6::Zero();
};

Reaction added_mass(const Hull& hull, const SlowMotion& slow, const Vec6& v, const Vec6& acc) {
  Reaction r;
  r.by_v = turning_of(hull.radiation.added_mass, slow.rate.z());
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

/// What turns with the body or stands in W: loads and ballast, on the hull.
void add_loads(const Hull& hull, const Vec6& h, double stiffness, HullBalance& out) {
  out.residual -= hull.ballast;
  if (hull.loads.empty()) return;
  const BodyPose pose = pose_of(h);
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
  const WayPoint at = keeping.move ? keeping.move->at(time) : WayPoint{};
  const Vec3 ahead(keeping.ahead_W.x(), keeping.ahead_W.y(), 0.0);
  const Vec3 off = to_h * (keeping.wanted + at.way * ahead - slow.value), rate = to_h * (slow.rate - at.speed * ahead);
  const Vec3 asked = keeping.law.stiffness.cwiseProduct(off) - keeping.law.damping.cwiseProduct(rate);
  return {asked, asked.cwiseMax(-keeping.law.limit).cwiseMin(keeping.law.limit)};
}

HullState hull_at_rest(const Hull& hull, const Vec6& h) {
  HullState state;
  state.h = h;
  state.radiation = fresh_memory(hull.radiation);
  state.slow = slow_rest(h);
  return state;
}

void balance_hull(const Hull& hull, const HullState& at, const HullState& before, double step,
                  const HullWeights& weights, double time, HullBalance& out) {
  const bool at_rest = weights.damping == 0.0 && weights.mass == 0.0, in_step = !at_rest && step > 0.0;
  HullSurroundings here;  // of this evaluation alone
  if (at_rest) {
    here = surroundings_at(hull, slow_rest(at.h), time);
  } else if (!in_step) {
    here = surroundings_after(hull, before, step, time);
  } else if (!out.surroundings) {
    out.surroundings = surroundings_after(hull, before, step, time);
  }
  const HullSurroundings& around = in_step ? *out.surroundings : here;
  const Mat6 T = turn_of(around.slow);
  const Vec6 v = T.transpose() * at.v, acc = T.transpose() * at.acc;

  const RigidBodyForce inertia = rigid_body_force(hull.body, at.h, at.v, at.acc);
  out.residual = inertia.force + hull.hydrostatics * (at.h - hull.drawn);
  out.tangent = weights.stiffness * (inertia.by_h + hull.hydrostatics) + weights.damping * inertia.by_v +
                weights.mass * inertia.by_a;

  const Reaction mass = added_mass(hull, around.slow, v, acc), losses = viscous(hull.damping, v);
  const OutsideForce outside = outside_force(hull, around, v);
  const RadiationStep& memory = around.memory;
  out.residual += T * (mass.force + memory.force_at_rest_end + memory.slope * v + losses.force - outside.sum);
  const Mat6 by_v = mass.by_v + memory.slope + losses.by_v - outside.by_v;
  out.tangent += T * (weights.damping * by_v + weights.mass * hull.radiation.added_mass) * T.transpose();

  add_loads(hull, at.h, weights.stiffness, out);
  if (at_rest) {
    Mat6 slopes = Mat6::Zero();
    add_slopes_at_rest(hull, around.slow, time, slopes);
    out.tangent += weights.stiffness * slopes;
  }
}

void finish_step(const Hull& hull, const HullState& before, double step, HullState& at) {
  at.slow = slow_motion_after(before.slow, before.h, at.h, step, hull.slow_period);
  at.radiation.values = before.radiation.values;
  advance(hull.radiation, at.radiation, rates_in_h(before.slow, before.v), rates_in_h(at.slow, at.v), step);
}

SteadyForces steady_forces(const Hull& hull, double psi) {
  SlowMotion slow;
  slow.value.z() = psi;
  const HullSurroundings around = surroundings_at(hull, slow, kBeforeWaves);
  return {outside_force(hull, around, Vec6::Zero()).current.force, around.wind, around.drift};
}

const char* hull_refusal(const HullState& state) {
  if (!state.h.allFinite() || !state.v.allFinite() || !state.acc.allFinite()) return "the hull's motion is not finite";
  if (std::abs(state.h(4)) > kSteepest) return "the hull pitches beyond 60 deg";
  return nullptr;
}

HullEnergy hull_energy(const Hull& hull, const HullState& state, double time,
                       const std::optional<HullSurroundings>& of_step) {
  HullEnergy e;
  const Vec6 v = rates_in_h(state.slow, state.v), off = state.h - hull.drawn;
  const bool at_hand = of_step && of_step->time == time;
  const HullSurroundings around = at_hand ? *of_step : surroundings_at(hull, state.slow, time);
  const OutsideForce outside = outside_force(hull, around, v);
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
