#include "mechanics/stinger_section.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/pipe/section.h"

namespace overbend {
namespace {

/// Minimum height of a strip relative to its diameter: a level tank does not submerge instantly.
constexpr double kMinHeight = 0.1;

/// Wetted fraction of a strip, and the middle of that part.
struct WetPart {
  double share = 0.0;
  Vec3 middle_V = Vec3::Zero();
};

WetPart wet_part(const TankStrip& strip, double from_z, double to_z, double surface) {
  const double rise = to_z - from_z;
  const double height = std::max(std::abs(rise), kMinHeight * strip.diameter);
  const double middle = 0.5 * (from_z + to_z);
  const double share = std::clamp(0.5 + (surface - middle) / height, 0.0, 1.0);
  const Vec3 along = strip.to_V - strip.from_V;
  return {share, 0.5 * (strip.from_V + strip.to_V) - 0.5 * (1.0 - share) * rise / height * along};
}

/// Calls `take(force, place, velocity of the place)` for every force on the section.
template <class Take>
void forces_of_water(const SectionBody& body, const RigidMotion& motion, std::span<const WaterState> water,
                     double weight_density, const Take& take) {
  const double density = weight_density / kGravity;
  const Mat3& R = motion.pose.R_WV;
  for (std::size_t i = 0; i < body.strips.size(); ++i) {
    const TankStrip& strip = body.strips[i];
    const WaterState& w = water[i];
    const double from_z = motion.pose.p_WV.z() + R.row(2).dot(strip.from_V);
    const double to_z = motion.pose.p_WV.z() + R.row(2).dot(strip.to_V);
    const WetPart wet = wet_part(strip, from_z, to_z, w.elevation);
    if (wet.share <= 0.0) continue;
    const Vec3 axis_V = strip.to_V - strip.from_V;
    const double length = wet.share * axis_V.norm();
    const double volume = 0.25 * std::numbers::pi * strip.diameter * strip.diameter * length;
    const Vec3 axis = (R * axis_V).normalized();
    const PointMotion middle = point_motion(motion, wet.middle_V);
    const auto across = [&](const Vec3& v) { return Vec3(v - v.dot(axis) * axis); };
    const Vec3 flow = across(w.velocity - middle.velocity);
    take(Vec3(density * volume * (w.acceleration + kGravity * Vec3::UnitZ()) +
              density * volume * strip.added_mass * across(w.acceleration - middle.acceleration) +
              0.5 * density * strip.drag * strip.diameter * length * flow.norm() * flow),
         middle);
  }
  if (body.immersed) {
    const ImmersedBody& part = *body.immersed;
    const WaterState& w = water[body.strips.size()];
    const Vec3 across = R * part.across_V;
    const PointMotion part_point = point_motion(motion, part.place_V);
    const double flow = across.dot(w.velocity - part_point.velocity);
    take(Vec3(density * part.volume * (w.acceleration + kGravity * Vec3::UnitZ()) +
              (part.added_mass * across.dot(w.acceleration - part_point.acceleration) +
               0.5 * density * part.drag_area * std::abs(flow) * flow) *
                  across),
         part_point);
  }
}

/// State of a spring: its tension, along `towards` from the section to the vessel.
struct SpringPull {
  double stretch = 0.0, tension = 0.0;
  Vec3 towards = Vec3::Zero();
  PointMotion tip, base;
};

SpringPull compute_spring_pull(const SectionSpring& spring, const RigidMotion& motion, const RigidMotion& barge) {
  SpringPull pull;
  pull.tip = point_motion(motion, spring.section_V);
  pull.base = point_motion(barge, spring.vessel_V);
  const Vec3 span = pull.base.place - pull.tip.place;
  const double length = span.norm();
  pull.stretch = length - spring.length;
  pull.stretch = spring.wire ? std::max(pull.stretch, 0.0) : pull.stretch;
  pull.tension = spring.stiffness * pull.stretch;
  pull.towards = length > 0.0 ? Vec3(span / length) : Vec3(Vec3::Zero());
  return pull;
}

}  // namespace

Vec3 current_at(const CurrentProfile& current, double z) {
  const std::size_t rows = current.z.size();
  if (rows == 0) {
    return Vec3::Zero();
  }
  const std::size_t above =
      static_cast<std::size_t>(std::upper_bound(current.z.begin(), current.z.end(), z) - current.z.begin());
  const std::size_t high = std::min(above, rows - 1), low = above == 0 ? 0 : above - 1;
  const double span = current.z[high] - current.z[low];
  const double share = span > 0.0 ? (z - current.z[low]) / span : 0.0;
  const auto between = [&](const std::vector<double>& v) { return v[low] + share * (v[high] - v[low]); };
  return {between(current.vx), between(current.vy), 0.0};
}

std::size_t water_places(const SectionBody& body) {
  return body.strips.size() + (body.immersed ? 1 : 0);
}

void water_at_section(const SectionSea& sea, double time, const SectionBody& body, const RigidMotion& motion,
                      std::span<Vec3> points, std::span<WaterState> water) {
  const auto place = [&](const Vec3& p_V) { return Vec3(motion.pose.p_WV + motion.pose.R_WV * p_V); };
  for (std::size_t i = 0; i < body.strips.size(); ++i) {
    points[i] = place(0.5 * (body.strips[i].from_V + body.strips[i].to_V));
  }
  if (body.immersed) {
    points[body.strips.size()] = place(body.immersed->place_V);
  }
  const BuildUp build_up = half_cosine(time, sea.build_up);
  std::fill(water.begin(), water.end(), WaterState{});
  if (!sea.sea.calm()) {
    water_state(sea.sea, time, build_up, points, water);
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    water[i].velocity += current_at(sea.current, points[i].z());
  }
}

Wrench section_residual(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                        std::span<const WaterState> water, double weight_density, const Vec3& about) {
  Wrench sum;
  const auto subtract = [&](const Vec3& force, const Vec3& place) {
    sum.force -= force;
    sum.moment -= (place - about).cross(force);
  };
  const PointMotion center = point_motion(motion, body.center_V);
  const Mat3 inertia = motion.pose.R_WV * body.inertia_V * motion.pose.R_WV.transpose();
  sum.moment += inertia * motion.alpha + motion.omega.cross(inertia * motion.omega);
  subtract(-body.mass * (center.acceleration + kGravity * Vec3::UnitZ()), center.place);
  forces_of_water(body, motion, water, weight_density,
                  [&](const Vec3& force, const PointMotion& point) { subtract(force, point.place); });
  for (const SectionSpring& spring : body.springs) {
    const SpringPull pull = compute_spring_pull(spring, motion, barge);
    subtract(pull.tension * pull.towards, pull.tip.place);
  }
  return sum;
}

Wrench springs_on_barge(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                        const Vec3& about) {
  Wrench sum;
  for (const SectionSpring& spring : body.springs) {
    const SpringPull pull = compute_spring_pull(spring, motion, barge);
    const Vec3 force = -pull.tension * pull.towards;
    sum.force += force;
    sum.moment += (pull.base.place - about).cross(force);
  }
  return sum;
}

SectionEnergy section_energy(const SectionBody& body, const RigidMotion& motion, const RigidMotion& barge,
                             std::span<const WaterState> water, double weight_density) {
  SectionEnergy sum;
  const PointMotion center = point_motion(motion, body.center_V);
  const Vec3 omega_V = motion.pose.R_WV.transpose() * motion.omega;
  sum.kinetic = 0.5 * body.mass * center.velocity.squaredNorm() + 0.5 * omega_V.dot(body.inertia_V * omega_V);
  sum.stored = body.mass * kGravity * center.place.z();
  forces_of_water(body, motion, water, weight_density,
                  [&](const Vec3& force, const PointMotion& point) { sum.power += force.dot(point.velocity); });
  for (const SectionSpring& spring : body.springs) {
    const SpringPull pull = compute_spring_pull(spring, motion, barge);
    sum.stored += 0.5 * spring.stiffness * pull.stretch * pull.stretch;
    sum.barge_power += pull.tension * pull.towards.dot(pull.base.velocity);
  }
  return sum;
}

double section_draught(const SectionBody& body, const RigidMotion& motion, std::span<const WaterState> water) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < body.strips.size(); ++i) {
    for (const Vec3& end_V : {body.strips[i].from_V, body.strips[i].to_V}) {
      const double z = motion.pose.p_WV.z() + motion.pose.R_WV.row(2).dot(end_V);
      deepest = std::max(deepest, water[i].elevation - z);
    }
  }
  return deepest;
}

}  // namespace overbend
