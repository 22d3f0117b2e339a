#include "checks/lift_rows.h"

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "checks/check_row.h"
#include "checks/check_section.h"
#include "checks/dnv_strength.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr CheckTitle kStress = {
    "lift_equivalent_stress", "Equivalent stress of lifted pipe, 0.87 f_y", kDnv, "sec. 13", "von Mises stress", "Pa"};

/// Of thin-walled pipe, from the pressure of its contents and of the water at a height [Pa].
double hoop_stress(const Section& pipe, double water_weight_density, double z) {
  const double outside = water_weight_density * std::max(-z, 0.0);
  const double bore = pipe.steel_diameter - 2.0 * pipe.wall_thickness;
  return (pressure_on_bore(pipe, z) * bore - outside * pipe.steel_diameter) / (2.0 * pipe.wall_thickness);
}

/// Von Mises stress of the fibre that is worse off: pulled by bending, or pressed.
double equivalent_stress(const LiftedNode& node, double hoop) {
  const double axial = node.tension / node.wall_area;
  double worst = 0.0;
  for (const double bending : {node.stress, -node.stress}) {
    const double along = axial + bending;
    worst = std::max(worst, std::sqrt(along * along - along * hoop + hoop * hoop));
  }
  return worst;
}

double limit_of(const CheckSettings& settings, double yield_stress) {
  const bool reduced = settings.yield_basis == YieldBasis::fy;
  return kStressShare * (reduced ? characteristic_strength(yield_stress, settings.alpha_u) : yield_stress);
}

/// The sections of a line's pipe with the arc lengths at which they end.
std::vector<std::pair<double, Section>> sections_of(const Description& description, const std::string& name) {
  const auto line = std::ranges::find(description.lines, name, &FreeLineDescription::name);
  std::vector<std::pair<double, Section>> sections;
  double end = 0.0;
  for (const LineSegmentDescription& segment : line->segments) {
    end += segment.length.value();
    if (!segment.section) continue;
    sections.emplace_back(end,
                          derive_section(segment.name, *segment.section, description.environment.water_weight_density));
  }
  return sections;
}

CheckRow stress_row(const Description& description, const LiftResults& lift) {
  CheckRow row = row_of(kStress, CheckRegion::line);
  double most = -1.0;
  for (const LiftedLine& line : lift.lines) {
    const std::vector<std::pair<double, Section>> sections = sections_of(description, line.name);
    for (const LiftedNode& node : line.nodes) {
      if (node.yield_stress <= 0.0) continue;
      const auto at = std::ranges::find_if(
          sections, [&](const auto& section) { return node.at.arc_length <= section.first * (1.0 + 1e-9); });
      if (at == sections.end()) continue;
      const double hoop = hoop_stress(at->second, description.environment.water_weight_density, node.at.place.z());
      const double stress = equivalent_stress(node, hoop), limit = limit_of(description.checks, node.yield_stress);
      if (stress / limit <= most) continue;
      most = stress / limit;
      row.s = node.at.arc_length;
      row.p_W = node.at.place;
      row.remark = "line '" + line.name + "', " + shown(row.s, "m", 1) + " from its first end";
      judge_ratio(row, stress, limit);
    }
  }
  return most < 0.0 ? not_done(row, "no line is pipe") : row;
}

}  // namespace

std::vector<CheckRow> lift_rows(const Description& description, const LiftResults& lift) {
  if (lift.lines.empty()) return {};
  return {stress_row(description, lift)};
}

}  // namespace overbend
