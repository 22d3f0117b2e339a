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

double built_up(const Hull& hull, double time) {
  return time == kBeforeWaves ? 0.0 : half_cosine(time, hull.build_up).value;
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

struct Surroundings {
  Vec6 waves = Vec6::Zero(), drift = Vec6::Zero(), wind = Vec6::Zero(), station = Vec6::Zero();
  CurrentForce current;

  Vec6 sum() const { return waves + drift + wind + station + current.force; }
};

Vec6 station_force(const StationKeeping& keeping, const SlowMotion& slow) {
  const Mat3 to_h = turned_about_z(-slow.value.z());
  const Vec3 off = to_h * (keeping.wanted - slow.value), rate = to_h * slow.rate;
  const Vec3 wanted = keeping.law.stiffness.cwiseProduct(off) - keeping.law.damping.cwiseProduct(rate);
  const Vec3 thrust = wanted.cwiseMax(-keeping.law.limit).cwiseMin(keeping.law.limit);
  return (Vec6() << thrust.x(), thrust.y(), 0.0, 0.0, 0.0, thrust.z()).finished();
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

Surroundings surroundings(const Hull& hull, const SlowMotion& slow, const Vec6& v, double time) {
  Surroundings s;
  const double share = built_up(hull, time);
  if (!hull.waves.empty() && (share > 0.0 || hull.mean_drift_from_start)) {
    const WaveForce f = wave_force(hull.waves, share > 0.0 ? time : 0.0, slow.value);
    s.waves = share * f.first_order;
    s.drift =
        hull.mean_drift_from_start ? Vec6(f.mean_drift + share * (f.drift - f.mean_drift)) : Vec6(share * f.drift);
    s.drift -= share * (hull.drift_damping * v);
  }
  s.current = current_force(hull.current, slow.value.z(), v, water_at_strips(hull, slow, time, share));
  s.current.force(5) += munk_moment(hull, slow);
  s.wind = wind_force(hull.wind, slow.value.z());
  if (hull.station_keeping) s.station = station_force(*hull.station_keeping, slow);
  return s;
}

/// At rest all of these follow the hull: their derivatives by x, y and psi.
void add_slopes_at_rest(const Hull& hull, const SlowMotion& slow, double time, Mat6& tangent) {
  const int columns[3] = {0, 1, 5};
  for (int k = 0; k < 3; ++k) {
    const double d = k < 2 ? 1e-3 : 1e-5;  // forces change over metres and degrees; exact for what is linear
    SlowMotion ahead = slow, behind = slow;
    ahead.value(k) += d;
    behind.value(k) -= d;
    const Vec6 difference = turn_of(ahead) * surroundings(hull, ahead, Vec6::Zero(), time).sum() -
                            turn_of(behind) * surroundings(hull, behind, Vec6::Zero(), time).sum();
    tangent.col(columns[k]) -= difference / (2.0 * d);
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

Reaction radiated(const Hull& hull, const HullState& before, double step, const Vec6& v) {
  Reaction r;
  if (step > 0.0) {
    const RadiationStep mu = radiation_step(hull.radiation, before.radiation, rates_in_h(before.slow, before.v), step);
    r.by_v = mu.slope;
    r.force = mu.force_at_rest_end + mu.slope * v;
  } else {
    r.force = radiation_force(hull.radiation, before.radiation, v);
  }
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

HullState hull_at_rest(const Hull& hull, const Vec6& h) {
  HullState state;
  state.h = h;
  state.radiation = fresh_memory(hull.radiation);
  state.slow = slow_rest(h);
  return state;
}

void balance_hull(const Hull& hull, const HullState& at, const HullState& before, double step,
                  const HullWeights& weights, double time, HullBalance& out) {
  const bool at_rest = weights.damping == 0.0 && weights.mass == 0.0;
  const SlowMotion slow =
      at_rest ? slow_rest(at.h) : slow_motion_after(before.slow, before.h, at.h, step, hull.slow_period);
  const Mat6 T = turn_of(slow);
  const Vec6 v = T.transpose() * at.v, acc = T.transpose() * at.acc;

  const RigidBodyForce inertia = rigid_body_force(hull.body, at.h, at.v, at.acc);
  out.residual = inertia.force + hull.hydrostatics * (at.h - hull.drawn);
  out.tangent = weights.stiffness * (inertia.by_h + hull.hydrostatics) + weights.damping * inertia.by_v +
                weights.mass * inertia.by_a;

  const Surroundings around = surroundings(hull, slow, v, time);
  const Reaction mass = added_mass(hull, slow, v, acc), losses = viscous(hull.damping, v);
  Reaction memory;
  if (!at_rest) memory = radiated(hull, before, step, v);
  out.residual += T * (mass.force + memory.force + losses.force - around.sum());
  const Mat6 by_v =
      mass.by_v + memory.by_v + losses.by_v - around.current.by_v + built_up(hull, time) * hull.drift_damping;
  out.tangent += T * (weights.damping * by_v + weights.mass * hull.radiation.added_mass) * T.transpose();

  add_loads(hull, at.h, weights.stiffness, out);
  if (at_rest) {
    Mat6 slopes = Mat6::Zero();
    add_slopes_at_rest(hull, slow, time, slopes);
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
  const Surroundings around = surroundings(hull, slow, Vec6::Zero(), kBeforeWaves);
  return {around.current.force, around.wind, around.drift};
}

const char* hull_refusal(const HullState& state) {
  if (!state.h.allFinite() || !state.v.allFinite() || !state.acc.allFinite()) return "the hull's motion is not finite";
  if (std::abs(state.h(4)) > kSteepest) return "the hull pitches beyond 60 deg";
  return nullptr;
}

HullEnergy hull_energy(const Hull& hull, const HullState& state, double time) {
  HullEnergy e;
  const Vec6 v = rates_in_h(state.slow, state.v), off = state.h - hull.drawn;
  const Surroundings around = surroundings(hull, state.slow, v, time);
  e.kinetic = kinetic_energy(hull.body, state.h, state.v) + 0.5 * v.dot(hull.radiation.added_mass * v);
  e.hydrostatic = 0.5 * off.dot(hull.hydrostatics * off);
  e.radiation = -v.dot(radiation_force(hull.radiation, state.radiation, v));
  e.waves = v.dot(around.waves);
  e.drift = v.dot(around.drift);
  e.current = v.dot(around.current.force);
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
