#include "system/line_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/ground.h"
#include "mechanics/point_load.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

constexpr double kBedSink = 0.01;         ///< Penetration of a point at rest on the seabed [m].
constexpr double kBedDampingShare = 0.5;  ///< Share of critical damping.
constexpr double kTautShare = 0.05;       ///< Share of the net force beyond which a tether is fully taut.

/// Position and motion of a point and of the water there.
struct PointState {
  Vec3 r = Vec3::Zero(), v = Vec3::Zero(), acc = Vec3::Zero();
  Vec3 water_v = Vec3::Zero(), water_a = Vec3::Zero();  ///< Waves only.
  double surface = 0.0;
};

PointState make_point_state(const LinePoint& point, const double* q, const LineMotion& motion) {
  const std::size_t first = 6 * static_cast<std::size_t>(point.node);
  PointState state;
  state.r = Vec3Map(q + first);
  if (motion.v != nullptr) {
    state.v = Vec3Map(motion.v + first);
    state.acc = Vec3Map(motion.acc + first);
  }
  if (motion.water != nullptr) {
    const double* water = motion.water + static_cast<std::size_t>(kWaterValues) * static_cast<std::size_t>(point.node);
    state.water_v = Vec3Map(water);
    state.water_a = Vec3Map(water + 3);
    state.surface = water[6];
  }
  return state;
}

/// A value with its total derivative by the position of the node.
struct Graded {
  double value = 0.0;
  Vec3 slope = Vec3::Zero();
};
struct GradedForce {
  Vec3 value = Vec3::Zero();
  Mat3 slope = Mat3::Zero();
};

Graded wetted(const LinePoint& point, const PointState& state) {
  const PointWetting wet = point_wetting(point.shape, point.half_height, state.r.z() + point.tether - state.surface);
  return {wet.share, wet.slope * Vec3::UnitZ()};
}

/// Depth of a point in the seabed, negative above it, with the normal and the derivatives by its position.
struct BedDepth {
  double value = 0.0;
  Vec3 normal = Vec3::UnitZ(), gradient = -Vec3::UnitZ();
  Mat3 turn = Mat3::Zero();
};

BedDepth bed_depth(const LineEnvironment& env, const Vec3& r, double tether) {
  if (env.bed_shape != nullptr) {
    const GroundPoint ground = ground_at(env, r + tether * Vec3::UnitZ());
    return {-ground.clearance, ground.normal, -ground.gradient, ground.turn};
  }
  const Vec3 n(Vec3Map(env.bed_normal));
  return {env.bed_offset - n.dot(r) - n.z() * tether, n, -n, Mat3::Zero()};
}

/// Upward force of the seabed.
Graded bed_force(const LinePoint& point, const LineEnvironment& env, const PointState& state, double velocity_share) {
  const BedDepth depth = bed_depth(env, state.r, point.tether);
  if (depth.value <= 0.0) return {};
  const double approach = -depth.normal.dot(state.v);
  Graded force{point.bed_stiffness * depth.value, point.bed_stiffness * depth.gradient};
  if (approach > 0.0) {
    force.value += point.bed_damping * approach;
    force.slope -= point.bed_damping * (velocity_share * depth.normal + depth.turn.transpose() * state.v);
  }
  return force;
}

/// Weight, buoyancy and seabed force.
Graded net_upward(const LinePoint& point, const Graded& wet, const Graded& bed) {
  return {point.buoyancy * wet.value - point.weight + bed.value, point.buoyancy * wet.slope + bed.slope};
}

/// Drag, added mass and the accelerated water at full immersion.
GradedForce water_force(const LinePoint& point, const LineEnvironment& env, const PointState& state,
                        const LineMotion& motion) {
  const Vec3 u = current_velocity(env, state.r.z()) + state.water_v - state.v;
  const double speed = u.norm();
  GradedForce force;
  force.value =
      point.drag * speed * u + point.added_mass * (state.water_a - state.acc) + point.displaced_mass * state.water_a;
  Mat3 in_u = point.drag * speed * Mat3::Identity();
  if (speed > 0.0) in_u += point.drag / speed * u * u.transpose();
  Mat3 u_in_r = -motion.velocity_share * Mat3::Identity();
  u_in_r.col(2) += current_slope(env, state.r.z());
  force.slope = in_u * u_in_r - point.added_mass * motion.acceleration_share * Mat3::Identity();
  return force;
}

/// Taut fraction of a tether with this upward force on the point: smooth from slack to a small part of its pull.
Graded taut(const LinePoint& point, const Graded& upward) {
  if (point.tether == 0.0) return {1.0, Vec3::Zero()};
  const double scale = std::copysign(kTautShare * std::abs(point.buoyancy - point.weight), point.tether);
  const double x = std::clamp(upward.value / scale, 0.0, 1.0);
  return {x * x * (3.0 - 2.0 * x), 6.0 * x * (1.0 - x) / scale * upward.slope};
}

GradedForce make_graded_force(const LinePoint& point, const LineEnvironment& env, const PointState& state,
                              const LineMotion& motion) {
  const Graded wet = wetted(point, state);
  const Graded upward = net_upward(point, wet, bed_force(point, env, state, motion.velocity_share));
  const Graded pull = taut(point, upward);
  const GradedForce water = water_force(point, env, state, motion);
  const Vec3 total = upward.value * Vec3::UnitZ() + wet.value * water.value - point.mass * state.acc;
  Mat3 slope = Vec3::UnitZ() * upward.slope.transpose() + wet.value * water.slope +
               water.value * wet.slope.transpose() - point.mass * motion.acceleration_share * Mat3::Identity();
  slope = pull.value * slope + total * pull.slope.transpose();
  return {pull.value * total, slope};
}

}  // namespace

LinePoint line_point(const Model& model, const LinePointDescription& description, int node) {
  LinePoint point;
  point.node = node;
  point.weight = std::max(description.mass * kGravity, -description.net_force);
  point.mass = point.weight / kGravity;
  point.buoyancy = point.weight + description.net_force;
  point.displaced_mass = point.buoyancy / model.water_weight_density * model.water_density;
  point.added_mass = description.added_mass;
  point.drag = 0.5 * model.water_density * description.drag_area;
  point.shape = description.shape;
  const double volume = description.volume > 0.0 ? description.volume : point.buoyancy / model.water_weight_density;
  const double radius = std::cbrt(0.75 * volume / std::numbers::pi);
  const bool cylinder = description.shape == BuoyShape::cylinder && description.height > 0.0;
  point.half_height = std::max(cylinder ? 0.5 * description.height : radius, 1e-3);
  point.tether = description.kind == PointKind::buoy ? description.tether : -description.tether;
  point.bed_stiffness = std::abs(description.net_force) / kBedSink;
  point.bed_damping = 2.0 * kBedDampingShare * std::sqrt(point.bed_stiffness * point.mass);
  return point;
}

Vec3 point_force(const LinePoint& point, const LineEnvironment& env, const double* q) {
  return make_graded_force(point, env, make_point_state(point, q, {}), {}).value;
}

void scale_forces(LinePoint& point, double factor) {
  for (double* force : {&point.weight, &point.buoyancy, &point.drag, &point.bed_stiffness}) *force *= factor;
}

PointWetting point_wetting(BuoyShape shape, double half_height, double z) {
  const double c = z / half_height;
  if (c <= -1.0) return {1.0, 0.0};
  if (c >= 1.0) return {0.0, 0.0};
  if (shape == BuoyShape::cylinder) return {0.5 * (1.0 - c), -0.5 / half_height};
  return {0.25 * (2.0 - 3.0 * c + c * c * c), 0.75 * (c * c - 1.0) / half_height};
}

void add_point_forces(std::span<const LinePoint> points, const LineEnvironment& env, const double* q,
                      const LineMotion& motion, double* residual, BlockTridiagonal* tangent) {
  for (const LinePoint& point : points) {
    const GradedForce force = make_graded_force(point, env, make_point_state(point, q, motion), motion);
    double* const diag = tangent != nullptr ? tangent->diag(point.node) : nullptr;
    for (int i = 0; i < 3; ++i) {
      residual[6 * point.node + i] -= force.value(i);
      for (int k = 0; diag != nullptr && k < 3; ++k) diag[i * kRowWidth + k] -= force.slope(i, k);
    }
  }
}

void add_point_energy(std::span<const LinePoint> points, const LineEnvironment& env, const double* q,
                      const LineMotion& motion, LineEnergy& sum) {
  for (const LinePoint& point : points) {
    const PointState state = make_point_state(point, q, motion);
    if (point.tether != 0.0) {
      sum.fluid_power += make_graded_force(point, env, state, motion).value.dot(state.v);
      continue;
    }
    const Graded wet = wetted(point, state);
    const Graded bed = bed_force(point, env, state, 0.0);
    const BedDepth depth = bed_depth(env, state.r, 0.0);
    const double penetration = std::max(0.0, depth.value);
    sum.kinetic += 0.5 * point.mass * state.v.squaredNorm();
    sum.gravity += point.weight * state.r.z();
    sum.fluid_power +=
        wet.value * (water_force(point, env, state, motion).value + point.buoyancy * Vec3::UnitZ()).dot(state.v);
    sum.seabed += 0.5 * point.bed_stiffness * penetration * penetration;
    sum.seabed_loss -= (bed.value - point.bed_stiffness * penetration) * state.v.z();
    if (env.bed_shape != nullptr) {  // the force is vertical, the depth is not: the difference counts as lost
      sum.seabed_loss -= point.bed_stiffness * penetration * (depth.gradient + Vec3::UnitZ()).dot(state.v);
    }
  }
}

}  // namespace overbend
