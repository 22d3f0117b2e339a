#include "statics/stinger/stinger_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/stinger_section.h"
#include "model/vessel/stinger_rotation.h"

namespace overbend {
namespace {

constexpr double kStripLength = 1.0;  ///< [m]
constexpr int kMinStrips = 8, kMaxStrips = 40;
constexpr double kRod = 1.0 / 12.0;  ///< Moment of inertia of a uniform rod about its middle, over m L^2.

Vec3 place_W(const Model& model, std::size_t section, const StingerPoint& drawn, double y = 0.0) {
  const StingerSectionDescription& described = model.description.supports.sections[section];
  return point_from_ramp(model, model.mean_pose,
                         point_on_section(described, model.supports.sections[section], drawn, y));
}

/// Axis of a tank in W.
struct TankAxis {
  Vec3 from, to;
  double length;
};

TankAxis make_tank_axis(const Model& model, std::size_t section, const StingerTankDescription& tank) {
  const Vec3 from = place_W(model, section, tank.from, tank.y), to = place_W(model, section, tank.to, tank.y);
  return {from, to, (to - from).norm()};
}

/// Part of an axis below z = 0, as fractions of its length.
struct WetPart {
  double from = 0.0, to = 0.0;
};

WetPart wet_part(const TankAxis& axis) {
  const double a = axis.from.z(), b = axis.to.z();
  if (a >= 0.0 && b >= 0.0) return {};
  if (a <= 0.0 && b <= 0.0) return {0.0, 1.0};
  const double cut = a / (a - b);
  return a < 0.0 ? WetPart{0.0, cut} : WetPart{cut, 1.0};
}

double area(const StingerTankDescription& tank) {
  return 0.25 * std::numbers::pi * tank.diameter * tank.diameter;
}

double drawn_length(const StingerTankDescription& tank) {
  return std::hypot(tank.to.x - tank.from.x, tank.to.z - tank.from.z);
}

double square_distance(const HingeAxis& hinge, const Vec3& point) {
  return hinge.axis_W.cross(point - hinge.at_W).squaredNorm();
}

/// Length of the uniform rod that represents the body: from the hinge to the last box of the section.
double body_length(const Model& model, std::size_t section) {
  double length = 0.0;
  for (const SupportBox& box : model.supports.boxes) {
    if (box.section != static_cast<int>(section)) continue;
    length = std::max(length, (box.point_S - model.supports.sections[section].hinge_S).norm());
  }
  return length;
}

double body_inertia(const Model& model, std::size_t section, const HingeAxis& hinge) {
  const StingerBodyDescription& body = *model.description.supports.sections[section].body;
  const double length = body_length(model, section);
  const double square = body.radius_of_gyration ? std::pow(*body.radius_of_gyration, 2) : kRod * length * length;
  const Vec3 centre = place_W(model, section, body.at),
             water = place_W(model, section, body.buoyancy_at.value_or(body.at));
  return body.weight / kGravity * (square + square_distance(hinge, centre)) +
         body.added_mass * square_distance(hinge, water);
}

/// Shell and ballast as a rod, and added mass across the axis: only the component of motion across counts, which is
/// proportional to the distance along the axis from the foot of the perpendicular from the hinge.
double tank_inertia(const Model& model, std::size_t section, const StingerTankDescription& tank,
                    const HingeAxis& hinge) {
  const TankAxis axis = make_tank_axis(model, section, tank);
  const Vec3 along = (axis.to - axis.from) / axis.length;
  const double foot = -(axis.from - hinge.at_W).dot(along);
  const double mass = (tank.weight + tank.ballast * tank_capacity(tank, model.water_weight_density)) / kGravity;
  const WetPart wet = wet_part(axis);
  const double low = wet.from * axis.length - foot, high = wet.to * axis.length - foot;
  const double water =
      tank.added_mass * model.water_density * area(tank) * (std::pow(high, 3) - std::pow(low, 3)) / 3.0;
  return mass * (kRod * axis.length * axis.length + square_distance(hinge, 0.5 * (axis.from + axis.to))) + water;
}

/// Adds the current drag across a tank's axis, strip by strip (Morison et al. 1950).
void add_drag(const Model& model, std::size_t section, const StingerTankDescription& tank,
              std::vector<PointForce>& forces) {
  const TankAxis axis = make_tank_axis(model, section, tank);
  const Vec3 along = (axis.to - axis.from) / axis.length;
  const int strips = tank_strips(axis.length);
  for (int i = 0; i < strips; ++i) {
    const auto point_at = [&](double share) { return Vec3(axis.from + (i + share) / strips * (axis.to - axis.from)); };
    const TankAxis strip{point_at(0.0), point_at(1.0), axis.length / strips};
    const WetPart wet = wet_part(strip);
    const Vec3 current = current_at(model.current, point_at(0.5).z()), across = current - current.dot(along) * along;
    const double drag = 0.5 * model.water_density * tank.drag * tank.diameter * (wet.to - wet.from) * strip.length;
    if (drag > 0.0) forces.push_back({drag * across.norm() * across, point_at(0.5 * (wet.from + wet.to))});
  }
}

/// Adds the current drag on the body, across the section.
void add_drag(const Model& model, std::size_t section, const StingerBodyDescription& body,
              std::vector<PointForce>& forces) {
  const Vec3 point = place_W(model, section, body.buoyancy_at.value_or(body.at));
  const Vec3 across = model.mean_pose.R_WV * Vec3::UnitY().cross(section_reach_V(model, section).normalized());
  const double flow = across.dot(current_at(model.current, point.z()));
  forces.push_back({0.5 * model.water_density * body.drag_area * std::abs(flow) * flow * across, point});
}

}  // namespace

Vec3 point_in_vessel(const Model& model, const Vec3& p_S) {
  const VesselDescription& v = model.description.vessel;
  return {v.stern_shoe_x - p_S.x(), -p_S.y(), v.stern_shoe_z + p_S.z()};
}

Vec3 section_reach_V(const Model& model, std::size_t section) {
  const StingerSectionDescription& described = model.description.supports.sections[section];
  const StingerSection& lies = model.supports.sections[section];
  const Vec3 hinge = point_in_vessel(model, lies.hinge_S);
  Vec3 reach = Vec3::Zero();
  const auto take = [&](const Vec3& p_S) {
    Vec3 to = point_in_vessel(model, p_S) - hinge;
    to.y() = 0.0;
    reach = to.norm() > reach.norm() ? to : reach;
  };
  for (const SupportBox& box : model.supports.boxes) {
    if (box.section == static_cast<int>(section)) take(box.point_S);
  }
  if (reach.norm() > 0.0) return reach;
  for (const StingerTankDescription& tank : described.tanks) {
    take(point_on_section(described, lies, tank.from));
    take(point_on_section(described, lies, tank.to));
  }
  return reach.norm() > 0.0 ? reach : Vec3(-Vec3::UnitX());
}

int tank_strips(double length) {
  return std::clamp(static_cast<int>(std::ceil(length / kStripLength)), kMinStrips, kMaxStrips);
}

double tank_capacity(const StingerTankDescription& tank, double water_weight_density) {
  return water_weight_density * area(tank) * drawn_length(tank);
}

FloatingTank floating_tank(const Model& model, std::size_t section, const StingerTankDescription& tank) {
  const TankAxis axis = make_tank_axis(model, section, tank);
  const WetPart wet = wet_part(axis);
  FloatingTank floats;
  floats.weight = tank.weight + tank.ballast * tank_capacity(tank, model.water_weight_density);
  floats.weight_at_W = 0.5 * (axis.from + axis.to);
  floats.submerged = wet.to - wet.from;
  floats.buoyancy = floats.submerged * tank_capacity(tank, model.water_weight_density);
  const double middle = floats.submerged > 0.0 ? 0.5 * (wet.from + wet.to) : 0.5;
  floats.buoyancy_at_W = axis.from + middle * (axis.to - axis.from);
  floats.draught = std::max({-axis.from.z(), -axis.to.z(), 0.0});
  return floats;
}

double spring_force(const StingerSectionDescription& section, const StingerSection& turned_section,
                    const StingerSpringDescription& spring) {
  const Vec3 barge_S(spring.on_barge.x, 0.0, spring.on_barge.z);
  const double drawn = std::hypot(spring.on_stinger.x - spring.on_barge.x, spring.on_stinger.z - spring.on_barge.z);
  const double length = (point_on_section(section, turned_section, spring.on_stinger) - barge_S).norm();
  const double force = spring.pretension + spring.stiffness * (length - drawn);
  return spring.wire ? std::max(force, 0.0) : force;
}

std::vector<PointForce> floating_forces(const Model& model, std::size_t section) {
  const StingerSectionDescription& described = model.description.supports.sections[section];
  std::vector<PointForce> forces;
  if (described.body) {
    const StingerBodyDescription& body = *described.body;
    forces.push_back({-body.weight * Vec3::UnitZ(), place_W(model, section, body.at)});
    forces.push_back({body.buoyancy * Vec3::UnitZ(), place_W(model, section, body.buoyancy_at.value_or(body.at))});
    if (!model.current.z.empty()) add_drag(model, section, body, forces);
  }
  for (const StingerTankDescription& tank : described.tanks) {
    const FloatingTank floats = floating_tank(model, section, tank);
    forces.push_back({-floats.weight * Vec3::UnitZ(), floats.weight_at_W});
    forces.push_back({floats.buoyancy * Vec3::UnitZ(), floats.buoyancy_at_W});
    if (!model.current.z.empty()) add_drag(model, section, tank, forces);
  }
  return forces;
}

std::vector<PointForce> section_forces(const Model& model, std::size_t section) {
  const StingerSectionDescription& described = model.description.supports.sections[section];
  std::vector<PointForce> forces = floating_forces(model, section);
  for (const StingerSpringDescription& spring : described.springs) {
    const Vec3 barge_S(spring.on_barge.x, 0.0, spring.on_barge.z);
    const Vec3 at_W = place_W(model, section, spring.on_stinger);
    const Vec3 to_vessel = point_from_ramp(model, model.mean_pose, barge_S) - at_W;
    const double force = spring_force(described, model.supports.sections[section], spring);
    if (to_vessel.norm() > 0.0) forces.push_back({force * to_vessel.normalized(), at_W});
  }
  return forces;
}

HingeAxis hinge_axis(const Model& model, std::size_t section) {
  return {point_from_ramp(model, model.mean_pose, model.supports.sections[section].hinge_S),
          direction_from_ramp(model.mean_pose, Vec3::UnitY())};
}

double moment_about(const HingeAxis& hinge, const std::vector<PointForce>& forces) {
  double moment = 0.0;
  for (const PointForce& force : forces) {
    moment += hinge.axis_W.dot((force.at_W - hinge.at_W).cross(force.force_W));
  }
  return moment;
}

double inertia_about_hinge(const Model& model, std::size_t section) {
  const HingeAxis hinge = hinge_axis(model, section);
  double inertia = 0.0;
  for (std::size_t i = section; i < model.supports.sections.size(); ++i) {
    const StingerSectionDescription& described = model.description.supports.sections[i];
    if (described.body) inertia += body_inertia(model, i, hinge);
    for (const StingerTankDescription& tank : described.tanks) inertia += tank_inertia(model, i, tank, hinge);
  }
  return inertia;
}

}  // namespace overbend
