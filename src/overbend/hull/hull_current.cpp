#include "hull/hull_current.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hull/body_kinematics.h"

namespace overbend {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;
constexpr double kViscosity = 1.19e-6;    // kinematic, of sea water at 15 deg C [m2/s]
constexpr double kLeastReynolds = 1.0e5;  // the friction line is not meant for less

/// A force of the flow past a point of the hull and its derivative by the relative velocity.
struct FlowForce {
  double force = 0.0, slope = 0.0;
};

FlowForce quadratic(double coefficient, double relative) {
  return {coefficient * std::abs(relative) * relative, 2.0 * coefficient * std::abs(relative)};
}

/// Skin friction by the line of ITTC 1957, 0.075 / (log10 Re - 2)^2.
FlowForce friction(const HullCurrent& c, double relative) {
  const double reynolds = std::abs(relative) * c.length / kViscosity;
  const double digits = std::log10(std::max(reynolds, kLeastReynolds)) - 2.0;
  const double area = 0.5 * c.water_density * c.wetted_surface, line = 0.075 / (digits * digits);
  FlowForce f = quadratic(area * line, relative);
  if (reynolds > kLeastReynolds) f.slope -= area * line * 2.0 / (digits * std::numbers::ln10) * std::abs(relative);
  return f;
}

/// Adds a force along a direction of H at a place of the hull: `lever` is the velocity of that place along the force
/// by the rates, and so the force by its share in each of the six.
void add_along(const Vec6& lever, const FlowForce& f, CurrentForce& out) {
  out.force += f.force * lever;
  out.by_v -= f.slope * (lever * lever.transpose());
}

CurrentForce strips(const HullCurrent& c, const Vec3& flow, const Vec6& v, const StripWater& waves) {
  CurrentForce out;
  const double z = -0.5 * c.draught - c.reference_V.z(), width = c.length / kHullStrips;
  double along = 0.0;
  for (int i = 0; i < kHullStrips; ++i) {
    const double x = strip_place(c, i) - c.reference_V.x();
    const Vec6 lever = (Vec6() << 0.0, 1.0, 0.0, -z, 0.0, x).finished();
    const double relative = flow.y() + (c.in_water ? waves.across[i] : 0.0) - lever.dot(v);
    add_along(lever, quadratic(0.5 * c.water_density * c.draught * c.transverse * width, relative), out);
    along += waves.along[i] / kHullStrips;
  }
  const Vec6 lever = (Vec6() << 1.0, 0.0, 0.0, 0.0, z, 0.0).finished();
  const double relative = flow.x() + (c.in_water ? along : 0.0) - lever.dot(v);
  const double form = 0.5 * c.water_density * c.beam * c.draught * c.longitudinal;
  add_along(lever, quadratic(form, relative), out);
  add_along(lever, friction(c, relative), out);
  return out;
}

struct TableRow {
  Vec3 value, slope;  ///< c_x, c_y, c_z and derivatives by the angle.
};

/// Linear between the rows of a periodic table.
TableRow table_at(const std::vector<CoefficientRow>& table, double angle) {
  const double a = angle - kTurn * std::floor(angle / kTurn);
  const auto after = std::upper_bound(table.begin(), table.end(), a,
                                      [](double value, const CoefficientRow& row) { return value < row.angle; });
  const CoefficientRow& high = after == table.end() ? table.front() : *after;
  const CoefficientRow& low = after == table.begin() ? table.back() : *(after - 1);
  const double from = after == table.begin() ? low.angle - kTurn : low.angle;
  const double to = after == table.end() ? high.angle + kTurn : high.angle;
  const Vec3 c0(low.cx, low.cy, low.cz), c1(high.cx, high.cy, high.cz);
  if (to <= from) return {c0, Vec3::Zero()};
  const Vec3 slope = (c1 - c0) / (to - from);
  return {c0 + slope * (a - from), slope};
}

CurrentForce by_table(const HullCurrent& c, const Vec3& flow, const Vec6& v) {
  CurrentForce out;
  const Eigen::Vector2d u(flow.x() - v(0), flow.y() - v(1));
  const double speed = u.norm();
  if (speed == 0.0 || c.table.empty()) return out;
  const TableRow row = table_at(c.table, std::atan2(u.y(), u.x()));
  const Vec3 size = 0.5 * c.water_density * Vec3(c.frontal_area, c.lateral_area, c.lateral_area * c.table_length);
  // 1/2 rho V^2 A c(angle): dV^2 = 2 u.du, d angle = (u x du) / V^2.
  const Vec3 value = size.cwiseProduct(row.value), slope = size.cwiseProduct(row.slope);
  const Vec3 at_midship = speed * speed * value;
  const Vec3 by_u = 2.0 * u.x() * value - u.y() * slope, by_w = 2.0 * u.y() * value + u.x() * slope;
  const auto put = [&](const Vec3& f) {
    // The table's moment is about midship on the water line's axis; the force acts on the centreline there.
    return (Vec6() << f.x(), f.y(), 0.0, 0.0, 0.0, f.z() - c.reference_V.x() * f.y() + c.reference_V.y() * f.x())
        .finished();
  };
  out.force = put(at_midship);
  out.by_v.col(0) = -put(by_u);
  out.by_v.col(1) = -put(by_w);
  return out;
}

}  // namespace

double strip_place(const HullCurrent& current, int i) {
  return current.length * ((i + 0.5) / kHullStrips - 0.5);
}

CurrentForce current_force(const HullCurrent& current, double psi, const Vec6& v, const StripWater& waves) {
  const Vec3 flow = turned_about_z(-psi) * Vec3(current.velocity.x(), current.velocity.y(), 0.0);
  switch (current.form) {
    case HullCurrentForm::none:
      break;
    case HullCurrentForm::strips:
      return strips(current, flow, v, waves);
    case HullCurrentForm::table:
      return by_table(current, flow, v);
  }
  return {};
}

std::vector<CoefficientRow> coefficients_from_bow(std::vector<CoefficientRow> rows, CoefficientAxes axes) {
  for (CoefficientRow& row : rows) {
    // From the bow, clockwise: the flow from ahead, 0, goes astern. OCIMF's 0 comes from the stern and goes ahead, 90
    // deg comes from starboard and goes to port: already where it goes to.
    if (axes == CoefficientAxes::from_bow) row.angle = std::numbers::pi - row.angle;
    row.angle -= kTurn * std::floor(row.angle / kTurn);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const CoefficientRow& a, const CoefficientRow& b) { return a.angle < b.angle; });
  const auto repeated = [](const CoefficientRow& a, const CoefficientRow& b) { return b.angle - a.angle < 1e-9; };
  rows.erase(std::unique(rows.begin(), rows.end(), repeated), rows.end());
  return rows;
}

double ufc_transverse_coefficient(double length, double beam, double draught, double midship, double volume,
                                  double depth) {
  const double open = 0.22 * std::sqrt(length * length * midship / (beam * volume)), share = draught / depth;
  return open + (3.2 - open) * share * share;
}

}  // namespace overbend
