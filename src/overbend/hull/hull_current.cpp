#include "hull/hull_current.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "hull/body_kinematics.h"

namespace overbend {
namespace {

constexpr double kViscosity = 1.19e-6;  // kinematic, of sea water at 15 deg C [m2/s]
constexpr double kMinReynolds = 1.0e5;  // lower limit of the friction line

/// Force of the flow past a point of the hull and its derivatives by the relative velocities along and across it.
struct FlowForce {
  double force = 0.0, slope = 0.0, across = 0.0;
};

FlowForce quadratic(double coefficient, double relative) {
  return {coefficient * std::abs(relative) * relative, 2.0 * coefficient * std::abs(relative)};
}

/// Force coefficient V u with the total speed V of a flow with components u along and w across the force.
FlowForce by_total_speed(double coefficient, double u, double w) {
  const double speed = std::hypot(u, w);
  if (speed == 0.0) return {};
  return {coefficient * speed * u, coefficient * (speed + u * u / speed), coefficient * u * w / speed};
}

/// Skin friction coefficient by the ITTC 1957 line, 0.075 / (log10 Re - 2)^2, and its derivative by the speed.
struct FrictionLine {
  double value = 0.0, slope = 0.0;
};

FrictionLine friction_line(const HullCurrent& c, double relative) {
  const double reynolds = std::abs(relative) * c.length / kViscosity;
  const double digits = std::log10(std::max(reynolds, kMinReynolds)) - 2.0, line = 0.075 / (digits * digits);
  if (reynolds <= kMinReynolds) return {line, 0.0};
  return {line, -line * 2.0 / (digits * std::numbers::ln10) / relative};
}

FlowForce friction(const HullCurrent& c, double relative) {
  const double area = 0.5 * c.water_density * c.wetted_surface;
  const FrictionLine line = friction_line(c, relative);
  FlowForce f = quadratic(area * line.value, relative);
  f.slope += area * line.slope * std::abs(relative) * relative;
  return f;
}

FlowForce ufc_friction(const HullCurrent& c, double relative, double across) {
  const double area = 0.5 * c.water_density * c.wetted_surface;
  const FrictionLine line = friction_line(c, relative);
  FlowForce f = by_total_speed(area * line.value, relative, across);
  f.slope += area * line.slope * std::hypot(relative, across) * relative;
  return f;
}

/// Adds a force along a direction of H at a point of the hull: `lever` is the derivative of the velocity of that point
/// along the force by the rates, and so gives its six components; `sideways` that of the velocity across it.
void add_along(const Vec6& lever, const Vec6& sideways, const FlowForce& f, CurrentForce& out) {
  out.force += f.force * lever;
  out.by_v -= lever * (f.slope * lever + f.across * sideways).transpose();
}

/// Cross-flow by strips, axial flow for the whole hull, both at half the draught.
CurrentForce strips(const HullCurrent& c, const Vec3& flow, const Vec6& v, const StripWater& waves) {
  CurrentForce out;
  const bool ufc = c.form == HullCurrentModel::ufc;
  const double z = -0.5 * c.draught - c.reference_V.z(), width = c.length / kHullStrips;
  double along = 0.0, across = 0.0;
  if (c.in_water) {
    for (int i = 0; i < kHullStrips; ++i) {
      along += waves.along[i] / kHullStrips;
      across += waves.across[i] / kHullStrips;
    }
  }
  const Vec6 ahead = (Vec6() << 1.0, 0.0, 0.0, 0.0, z, 0.0).finished();
  const double u = flow.x() + along - ahead.dot(v);
  const double side = 0.5 * c.water_density * c.draught * c.transverse * width;
  for (int i = 0; i < kHullStrips; ++i) {
    const double x = strip_place(c, i) - c.reference_V.x();
    const Vec6 lever = (Vec6() << 0.0, 1.0, 0.0, -z, 0.0, x).finished();
    const double relative = flow.y() + (c.in_water ? waves.across[i] : 0.0) - lever.dot(v);
    add_along(lever, ahead, ufc ? by_total_speed(side, relative, u) : quadratic(side, relative), out);
  }
  const Vec6 midship = (Vec6() << 0.0, 1.0, 0.0, -z, 0.0, -c.reference_V.x()).finished();
  const double w = flow.y() + across - midship.dot(v);
  const double form = 0.5 * c.water_density * c.beam * c.draught * c.longitudinal;
  add_along(ahead, midship, ufc ? by_total_speed(form, u, w) : quadratic(form, u), out);
  add_along(ahead, midship, ufc ? ufc_friction(c, u, w) : friction(c, u), out);
  return out;
}

CurrentForce by_table(const HullCurrent& c, const Vec3& flow, const Vec6& v) {
  const Eigen::Vector2d relative(flow.x() - v(0), flow.y() - v(1));
  const FlowOnTable f = flow_on_table(c.table, c.water_density, relative);
  const auto put = [&](const Vec3& at_midship) { return about_reference(at_midship, c.reference_V); };
  CurrentForce out;
  out.force = put(f.force);
  out.by_v.col(0) = -put(f.by_flow.col(0));
  out.by_v.col(1) = -put(f.by_flow.col(1));
  return out;
}

}  // namespace

double strip_place(const HullCurrent& current, int i) {
  return current.length * ((i + 0.5) / kHullStrips - 0.5);
}

CurrentForce current_force(const HullCurrent& current, double psi, const Vec6& v, const StripWater& waves) {
  const Vec3 flow = turned_about_z(-psi) * Vec3(current.velocity.x(), current.velocity.y(), 0.0);
  switch (current.form) {
    case HullCurrentModel::none:
      break;
    case HullCurrentModel::strips:
    case HullCurrentModel::ufc:
      return strips(current, flow, v, waves);
    case HullCurrentModel::table:
      return by_table(current, flow, v);
  }
  return {};
}

double ufc_transverse_coefficient(const UfcHull& hull, double depth) {
  const double slenderness = hull.length * hull.length * hull.midship / (hull.beam * hull.volume);
  const double open = 0.22 * std::sqrt(slenderness), share = hull.draught / depth;
  return open + (3.2 - open) * share * share;
}

double ufc_wetted_surface(const UfcHull& hull) {
  return 1.7 * hull.draught * hull.length + hull.volume / hull.draught;
}

}  // namespace overbend
