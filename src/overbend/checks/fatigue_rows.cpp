#include <algorithm>

#include "checks/check_row.h"
#include "checks/check_rows.h"
#include "checks/fatigue_curve.h"

namespace overbend {
namespace {

/// Where the line is at `s` from the anchor in the static state.
Vec3 place_at(const DynamicResults& dynamics, double s) {
  const auto at = std::lower_bound(dynamics.station_s.begin(), dynamics.station_s.end(), s);
  const auto i = std::min(at - dynamics.station_s.begin(), static_cast<std::ptrdiff_t>(dynamics.station_s.size()) - 1);
  return dynamics.static_place[static_cast<std::size_t>(i)];
}

}  // namespace

std::vector<CheckRow> fatigue_rows(const DynamicResults& dynamics) {
  static constexpr CheckTitle kTitle = {"fatigue", "Fatigue of welds on their way",        kFatigueCode,
                                        "2.4",     "damage from the tensioner to the bed", "1"};
  if (!dynamics.fatigue || dynamics.fatigue->spots.empty()) return {};
  const FatigueResults& fatigue = *dynamics.fatigue;
  const FatigueSpot& worst =
      *std::max_element(fatigue.spots.begin(), fatigue.spots.end(),
                        [](const FatigueSpot& a, const FatigueSpot& b) { return a.path_damage < b.path_damage; });
  CheckRow row = row_of(kTitle, CheckRegion::line);
  row.s = worst.worst_s;
  row.from_top = dynamics.station_s.back() - worst.worst_s;
  row.p_W = place_at(dynamics, worst.worst_s);
  judge_ratio(row, fatigue.design_factor * worst.path_damage, fatigue.budget);
  row.remark = "spot '" + worst.name + "', curve " + worst.curve + "; no standby in it";
  row.inputs = {{"DFF", "design fatigue factor", fatigue.design_factor, "1"},
                {"SCF", "stress factor", worst.stress_factor, "1"}};
  return {row};
}

}  // namespace overbend
