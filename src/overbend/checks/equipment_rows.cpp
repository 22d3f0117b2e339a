#include <fmt/format.h>

#include <cmath>

#include "base/shown_unit.h"
#include "checks/check_row.h"
#include "checks/check_rows.h"
#include "checks/mooring_rows.h"
#include "model/lay_route.h"
#include "model/lay_stage.h"

namespace overbend {
namespace {

constexpr const char* kProject = "project limit";

/// Roller with the maximum of some measure, and the name of its box.
struct WorstRoller {
  double value = 0.0, s = 0.0;
  Vec3 p_W = Vec3::Zero();
  std::string box;
};

/// Keeps the larger value with arc length and position of its row, or of the box if the pipe does not cross the row.
void keep_larger(WorstRoller& worst, double value, const SupportResult& box, const RowResult* row) {
  if (value <= worst.value && !worst.box.empty()) return;
  const bool crossed = row != nullptr && row->s >= 0.0;
  worst = {value, crossed ? row->s : box.s, row != nullptr ? row->p_W : box.p_W, box.name};
}

/// Evaluates `of_state(roller, row)` in statics and `of_run(roller)` over a run.
template <class OfState, class OfRun>
WorstRoller worst_roller(const StaticResults& statics, const DynamicResults* dynamics, OfState of_state, OfRun of_run) {
  WorstRoller worst;
  for (std::size_t i = 0; i < statics.supports.size(); ++i) {
    const SupportResult& box = statics.supports[i];
    if (dynamics == nullptr) {
      for (const RowResult& row : box.rows) {
        for (const RollerResult& roller : row.rollers) keep_larger(worst, of_state(roller), box, &row);
      }
      continue;
    }
    for (const RollerDynamics& roller : dynamics->supports[i].rollers) {
      const auto row = static_cast<std::size_t>(roller.row);
      keep_larger(worst, of_run(roller), box, row < box.rows.size() ? &box.rows[row] : nullptr);
    }
  }
  return worst;
}

CheckRow roller_row(const CheckTitle& title, const WorstRoller& worst, double limit, const StaticResults& statics) {
  CheckRow row = make_row(title, CheckRegion::line);
  row.s = worst.s;
  row.from_top = statics.stations.back().s - worst.s;
  row.p_W = worst.p_W;
  set_utilisation(row, worst.value, limit);
  row.remark = "at " + worst.box;
  return row;
}

/// Roller forces of a run are maxima over the run, without a common instant.
void add_rollers(std::vector<CheckRow>& rows, const Model& model, const StaticResults& statics,
                 const DynamicResults* dynamics) {
  static constexpr CheckTitle kForce = {"roller_load", "Roller force", kProject, "", "force of one roller", "N"};
  static constexpr CheckTitle kLine = {
      "coating_line_load", "Line load on the coating", kProject, "", "force per length of coating", "N/m"};
  const EquipmentLimits& limits = model.description.checks.limits;
  if (statics.supports.empty()) {
    for (const auto& [limit, title] : {std::pair{limits.roller_load, kForce}, {limits.coating_line_load, kLine}}) {
      if (limit) rows.push_back(not_done(make_row(title, CheckRegion::line), "the line has no rollers"));
    }
    return;
  }
  if (limits.roller_load) {
    const WorstRoller worst = worst_roller(
        statics, dynamics, [](const RollerResult& r) { return r.reaction; },
        [](const RollerDynamics& r) { return r.reaction.max; });
    rows.push_back(roller_row(kForce, worst, *limits.roller_load, statics));
  }
  if (limits.coating_line_load) {
    const WorstRoller worst = worst_roller(
        statics, dynamics, [](const RollerResult& r) { return r.line_load; },
        [](const RollerDynamics& r) { return r.line_load; });
    rows.push_back(roller_row(kLine, worst, *limits.coating_line_load, statics));
  }
}

void add_tension(std::vector<CheckRow>& rows, double limit, const StaticResults& statics,
                 const DynamicResults* dynamics) {
  static constexpr CheckTitle kTitle = {
      "tensioner_load", "Tension at the tensioner", kProject, "", "effective tension", "N"};
  CheckRow row = make_row(kTitle, CheckRegion::line);
  row.s = statics.stations.back().s;
  row.p_W = statics.stations.back().p_W;
  set_utilisation(row, std::max(0.0, dynamics != nullptr ? dynamics->top_tension.max : statics.top_tension), limit);
  rows.push_back(row);
}

/// Adds a minimum distance: required over available distance.
void add_tip(std::vector<CheckRow>& rows, double limit, const StaticResults& statics, const DynamicResults* dynamics) {
  static constexpr CheckTitle kTitle = {
      "tip_clearance", "Clearance at the stinger tip", kProject, "", "distance between pipe and roller", "m"};
  if (!statics.stinger_tip_clearance || statics.supports.empty()) {
    const char* const why =
        statics.supports.empty() ? "the line has no rollers" : "the pipe does not pass the last roller of a stinger";
    rows.push_back(not_done(make_row(kTitle, CheckRegion::line), why));
    return;
  }
  const double clearance = dynamics != nullptr ? dynamics->stinger_tip_clearance.min : *statics.stinger_tip_clearance;
  CheckRow row = make_row(kTitle, CheckRegion::line);
  if (std::isnan(clearance)) {
    rows.push_back(not_done(row, "the pipe never passed the last roller of the stinger"));
    return;
  }
  row.s = statics.supports.back().s;
  row.from_top = statics.stations.back().s - row.s;
  row.p_W = statics.supports.back().p_W;
  row.demand = limit;
  row.capacity = clearance;
  row.utilisation = clearance > 0.0 ? std::min(limit / clearance, kMaxReserve) : kMaxReserve;
  row.reserve = std::max(0.0, clearance / limit);
  row.remark = "demand is the required distance, capacity the minimum found";
  set_row_verdict(row);
  rows.push_back(row);
}

/// Maximum tension of the cable with its location: of the static state, or over a run.
struct CableLoad {
  double tension = 0.0, s = 0.0;
  Vec3 p_W = Vec3::Zero();
};

CableLoad cable_load(const Model& model, const StaticResults& statics, const DynamicResults* dynamics) {
  CableLoad load;
  const double total = statics.stations.back().s;
  const std::size_t count = dynamics != nullptr ? dynamics->station_s.size() : statics.stations.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double s = dynamics != nullptr ? dynamics->station_s[i] : statics.stations[i].s;
    const double tension =
        dynamics != nullptr ? dynamics->effective_tension.max[i] : statics.stations[i].effective_tension;
    if (tension <= load.tension || model.kind_at(total - s) != SectionKind::cable) continue;
    load = {tension, s, dynamics != nullptr ? dynamics->static_place[i] : statics.stations[i].p_W};
  }
  return load;
}

void add_cable(std::vector<CheckRow>& rows, const Model& model, const StaticResults& statics,
               const DynamicResults* dynamics) {
  static constexpr CheckTitle kTitle = {
      "cable_load", "Cable, breaking load over safety factor", "safety factor", "", "effective tension", "N"};
  const CheckRow row = make_row(kTitle, CheckRegion::line);
  const std::optional<double> breaking_load = model.description.operation.lay.cable->breaking_load;
  if (!breaking_load) {
    rows.push_back(not_done(row, "the cable's breaking load is not given (operation.cable.breaking_load)"));
    return;
  }
  const CableLoad load = cable_load(model, statics, dynamics);
  rows.push_back(row);
  rows.back().s = load.s;
  rows.back().from_top = statics.stations.back().s - load.s;
  rows.back().p_W = load.p_W;
  const SafetyFactor factor = cable_safety_factor(model.description.checks.safety_factors);
  set_utilisation(rows.back(), load.tension, *breaking_load / factor.value);
  rows.back().remark = fmt::format("breaking load of {} over a safety factor of {:.3g} ({})",
                                   shown(*breaking_load, "N", 1), factor.value, factor.source);
  rows.back().inputs = {{"T", "effective tension", load.tension, "N"},
                        {"MBL", "breaking load", *breaking_load, "N"},
                        {"n", "safety factor", factor.value, "1"}};
}

/// Adds a bend of the route behind touchdown: radius held by friction with a margin, over the actual radius.
void add_route(std::vector<CheckRow>& rows, const StaticResults& statics) {
  static constexpr CheckTitle kTitle = {
      "route_radius", "Radius of the route", "H / (mu w)", "", "minimum radius times 1.5", "m"};
  if (!statics.route || statics.route->radius <= 0.0) return;
  CheckRow row = make_row(kTitle, CheckRegion::line);
  row.s = statics.touchdown.s;
  row.from_top = statics.stations.back().s - statics.touchdown.s;
  row.p_W = statics.touchdown.p_W;
  if (statics.route->min_stable_radius <= 0.0) {
    rows.push_back(not_done(row, "the seabed has no lateral friction to hold a bend"));
    return;
  }
  set_utilisation(row, kRouteReserve * statics.route->min_stable_radius, statics.route->radius);
  row.remark = statics.route->holds ? "the bend holds; required is 1.5 times the minimum radius"
                                    : "the bend does not hold: the pipe slides towards its chord";
  rows.push_back(row);
}

}  // namespace

std::vector<CheckRow> equipment_rows(const Model& model, const StaticResults& statics, const DynamicResults* dynamics) {
  const EquipmentLimits& limits = model.description.checks.limits;
  std::vector<CheckRow> rows;
  if (!statics.has_pipe()) return rows;
  add_rollers(rows, model, statics, dynamics);
  if (limits.tension) add_tension(rows, *limits.tension, statics, dynamics);
  if (limits.tip_clearance) add_tip(rows, *limits.tip_clearance, statics, dynamics);
  if (cable_at_top(model.description) || cable_at_far_end(model.description)) {
    add_cable(rows, model, statics, dynamics);
  }
  add_route(rows, statics);
  return rows;
}

}  // namespace overbend
