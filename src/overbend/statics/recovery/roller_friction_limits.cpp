#include "statics/recovery/roller_friction_limits.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/steady_laying.h"

namespace overbend {
namespace {

/// Position of the pipe at an arc length, interpolated between stations.
Vec3 place_at(const std::vector<Station>& stations, double s) {
  const auto after =
      std::lower_bound(stations.begin(), stations.end(), s, [](const Station& a, double v) { return a.s < v; });
  if (after == stations.begin()) return stations.front().p_W;
  if (after == stations.end()) return stations.back().p_W;
  const Station &b = *after, &a = *(after - 1);
  return a.p_W + (s - a.s) / (b.s - a.s) * (b.p_W - a.p_W);
}

/// Maximum distance of the pipe beyond the ends of the loaded rollers of the last box [m].
double off_last_box(const SupportResult& box) {
  double off = 0.0;
  for (const RowResult& row : box.rows) {
    for (const RollerResult& roller : row.rollers) {
      if (roller.reaction > 0.0) off = std::max(off, roller.off_end);
    }
  }
  return off;
}

/// Sets the position of the pipe at the last row of the stinger.
void put_tip(RollerFrictionCase& answer, const StaticResults& results) {
  if (results.supports.empty() || !results.supports.back().stinger || results.supports.back().rows.empty()) return;
  answer.off_roller = off_last_box(results.supports.back());
  const RowResult& tip = results.supports.back().rows.back();
  if (tip.s < 0.0) return;
  answer.tip_side = (place_at(results.stations, tip.s) - results.stern_shoe_W).dot(results.R_WV.col(1));
}

/// Friction limit: its direction along the pipe, and across the rollers.
struct Limit {
  std::string name;
  RollerFriction along = RollerFriction::none;
  double across = 0.0;
  SeabedLayHistory laying = SeabedLayHistory::steady;
};

std::vector<Limit> make_limits(const Model& model, const StaticResults& results) {
  const auto has = [&](double Roller::*friction) {
    return ranges::any_of(model.supports.rollers, [&](const Roller& roller) { return roller.*friction > 0.0; });
  };
  const StaticSettings& statics = model.description.statics;
  const bool axial = has(&Roller::friction_axial), lateral = has(&Roller::friction_lateral);
  std::vector<Limit> limits;
  if (axial || lateral) limits.push_back({"frictionless", RollerFriction::none, 0.0, statics.laying});
  if (axial) {
    limits.push_back({"lay", RollerFriction::lay, 0.0, statics.laying});
    limits.push_back({"haul", RollerFriction::haul, 0.0, statics.laying});
  }
  if (lateral) {
    limits.push_back({"port", statics.roller_friction, 1.0, statics.laying});
    limits.push_back({"starboard", statics.roller_friction, -1.0, statics.laying});
  }
  if (lays_steadily(model) && results.route) {
    limits.push_back({"pulled across", statics.roller_friction, 0.0, SeabedLayHistory::pulled_sideways});
  }
  return limits;
}

/// True if the assumed friction drives the pipe instead of resisting it: the pipe is suspended below the tensioner, and
/// rollers that resist its motion cannot pull it down harder than the tensioner holds it.
bool is_driven_by_friction(const StaticResults& found) {
  return found.bottom_tension > found.top_tension;
}

}  // namespace

RollerFrictionCase friction_case(const std::string& name, const StaticResults& results) {
  RollerFrictionCase answer;
  answer.name = name;
  answer.top_tension = results.top_tension;
  answer.bottom_tension = results.bottom_tension;
  answer.lay_back = results.lay_back;
  if (results.overbend) answer.overbend_stress = results.overbend->von_mises.value;
  answer.sagbend_stress = results.sagbend.von_mises.value;
  answer.max_reaction = results.max_reaction;
  put_tip(answer, results);
  return answer;
}

void find_roller_friction_limits(const Model& model, const StaticSolution& solution, StaticResults& results) {
  results.roller_friction.clear();
  for (const Limit& limit : make_limits(model, results)) {
    Model with = model;
    with.description.statics.roller_friction = limit.along;
    with.description.statics.laying = limit.laying;
    LoadHistory past = solution.past;
    past.across_rollers = limit.across;
    const StaticOutcome outcome = solve_statics(with, &solution, past);
    const auto warn = [&](const std::string& why) {
      results.findings.push_back(Finding{FindingCode::friction_limit_not_found,
                                         fmt::format("effect of roller friction, limit '{}': {}", limit.name, why)}
                                     .on(limit.name));
    };
    if (!outcome.solution) {
      warn("no equilibrium found: " + (outcome.failure ? outcome.failure->what : "no reason given"));
      continue;
    }
    const StaticResults found = recover_state(with, *outcome.solution);
    if (is_driven_by_friction(found)) {
      warn(fmt::format("omitted: friction would raise the tension to {} at touchdown, more than at the tensioner",
                       shown(found.bottom_tension, "N", 0)));
      continue;
    }
    for (const Finding& finding : found.findings) {  // its other findings are in the row of the limit
      if (finding.code == FindingCode::steady_laying_not_found) warn(finding.message);
    }
    results.roller_friction.push_back(friction_case(limit.name, found));
  }
}

}  // namespace overbend
