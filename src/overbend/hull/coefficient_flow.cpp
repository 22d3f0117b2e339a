#include "hull/coefficient_flow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.h"

namespace overbend {
namespace {

struct TableRow {
  Vec3 value, slope;  ///< c_x, c_y, c_z and derivatives by the angle.
};

/// Linear interpolation in a periodic table.
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

}  // namespace

FlowOnTable flow_on_table(const CoefficientTable& table, double density, const Eigen::Vector2d& flow) {
  FlowOnTable out;
  const double speed = flow.norm();
  if (speed == 0.0 || table.rows.empty()) return out;
  const TableRow row = table_at(table.rows, std::atan2(flow.y(), flow.x()));
  const Vec3 size = 0.5 * density * Vec3(table.frontal_area, table.lateral_area, table.lateral_area * table.length);
  // 1/2 rho V^2 A c(angle): dV^2 = 2 u.du, d angle = (u x du) / V^2.
  const Vec3 value = size.cwiseProduct(row.value), slope = size.cwiseProduct(row.slope);
  out.force = speed * speed * value;
  out.by_flow.col(0) = 2.0 * flow.x() * value - flow.y() * slope;
  out.by_flow.col(1) = 2.0 * flow.y() * value + flow.x() * slope;
  return out;
}

Vec6 about_reference(const Vec3& at_midship, const Vec3& reference_V) {
  const double moment = at_midship.z() - reference_V.x() * at_midship.y() + reference_V.y() * at_midship.x();
  return (Vec6() << at_midship.x(), at_midship.y(), 0.0, 0.0, 0.0, moment).finished();
}

std::vector<CoefficientRow> coefficients_from_bow(std::vector<CoefficientRow> rows, CoefficientAxes axes) {
  for (CoefficientRow& row : rows) {
    // From the bow, clockwise: a flow from ahead, 0, goes astern. In OCIMF 0 is from the stern towards ahead, and 90
    // deg from starboard to port: already the direction it goes to.
    if (axes == CoefficientAxes::from_bow) row.angle = std::numbers::pi - row.angle;
    row.angle -= kTurn * std::floor(row.angle / kTurn);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const CoefficientRow& a, const CoefficientRow& b) { return a.angle < b.angle; });
  const auto repeated = [](const CoefficientRow& a, const CoefficientRow& b) { return b.angle - a.angle < 1e-9; };
  rows.erase(std::unique(rows.begin(), rows.end(), repeated), rows.end());
  return rows;
}

}  // namespace overbend
