#include "checks/lift_rows.h"

#include <cmath>

#include "base/shown_unit.h"
#include "checks/check_row.h"
#include "checks/check_section.h"
#include "checks/dnv_strength.h"

namespace overbend {
namespace {

constexpr CheckTitle kStress = {"lift_equivalent_stress",
                                "Equivalent stress of lifted pipe, 0.87 f_y",
                                kDnv,
                                "sec. 13",
                                "longitudinal stress",
                                "Pa"};

/// Of bending and the effective tension, which add up; without pressure inside the longitudinal stress is the larger
/// part of the equivalent one.
double stress_of(const LiftedNode& node) {
  return node.stress + std::abs(node.tension) / node.wall_area;
}

CheckRow stress_row(const CheckSettings& settings, const LiftResults& lift) {
  CheckRow row = row_of(kStress, CheckRegion::line);
  const LiftedNode* worst = nullptr;
  const LiftedLine* of = nullptr;
  for (const LiftedLine& line : lift.lines) {
    for (const LiftedNode& node : line.nodes) {
      if (node.yield_stress <= 0.0) continue;
      if (worst != nullptr && stress_of(node) / node.yield_stress <= stress_of(*worst) / worst->yield_stress) continue;
      worst = &node;
      of = &line;
    }
  }
  if (worst == nullptr) return not_done(row, "no line is pipe");
  const double fy = settings.yield_basis == YieldBasis::fy
                        ? characteristic_strength(worst->yield_stress, settings.alpha_u)
                        : worst->yield_stress;
  row.s = worst->at.arc_length;
  row.p_W = worst->at.place;
  row.remark = "line '" + of->name + "', " + shown(row.s, "m", 1) + " from its first end";
  judge_ratio(row, stress_of(*worst), kStressShare * fy);
  return row;
}

}  // namespace

std::vector<CheckRow> lift_rows(const CheckSettings& settings, const LiftResults& lift) {
  if (lift.lines.empty()) return {};
  return {stress_row(settings, lift)};
}

}  // namespace overbend
