#include "report/dynamic/mooring_histories.h"

#include <algorithm>
#include <array>

#include "report/dynamic/history_data.h"
#include "report/page/json_number.h"

namespace overbend {
namespace {

struct Moving {
  const char* freedom;
  MotionStatistics VesselDynamics::*motion;
  const char* title;
};
constexpr std::array<Moving, 3> kMoving = {{{"surge", &VesselDynamics::surge, "Surge from the nominal pose"},
                                            {"sway", &VesselDynamics::sway, "Sway from the nominal pose"},
                                            {"yaw", &VesselDynamics::yaw, "Yaw from the nominal pose"}}};

const HistorySummary* find(const DynamicResults& results, const std::string& name) {
  const auto found = std::find_if(results.histories.begin(), results.histories.end(),
                                  [&](const HistorySummary& h) { return h.name == name; });
  return found == results.histories.end() || found->low.empty() || found->low.size() != found->high.size() ? nullptr
                                                                                                           : &*found;
}

Json spread_data(const SummaryStatistics& spread, const Quantity& q) {
  return {{"min", json_number(q.shown(spread.min))},
          {"max", json_number(q.shown(spread.max))},
          {"mean", json_number(q.shown(spread.mean))},
          {"std", json_number(q.shown(spread.std))}};
}

Json entry(const HistorySummary& history, const std::string& group, const std::string& title,
           const SummaryStatistics& over_time, double before) {
  const Quantity q = quantity(history.name, history.units);
  Json trace = history_trace(history, q);
  if (trace.is_null()) return trace;
  trace.update({{"group", group},
                {"title", title},
                {"unit", q.unit},
                {"digits", q.digits},
                {"description", history.description},
                {"over_time", spread_data(over_time, q)},
                {"static", json_number(q.shown(before))}});
  return trace;
}

double start_offset(const VesselDynamics& vessel, const std::string& freedom) {
  return freedom == "surge" ? vessel.start_surge : freedom == "sway" ? vessel.start_sway : vessel.start_yaw;
}

void add_offsets(const DynamicResults& results, Json& out) {
  for (const Moving& moving : kMoving) {
    const std::string freedom = moving.freedom;
    const HistorySummary* total = find(results, "vessel/" + freedom);
    if (total == nullptr) continue;
    Json trace = entry(*total, "offset", moving.title, (*results.vessel.*moving.motion).whole,
                       start_offset(*results.vessel, freedom));
    if (trace.is_null()) continue;
    if (const HistorySummary* slow = find(results, "vessel/slow_" + freedom)) {
      trace["slow"] = history_trace(*slow, quantity(slow->name, slow->units));
    }
    out.push_back(std::move(trace));
  }
}

}  // namespace

Json operation_history_data(const DynamicResults& results) {
  constexpr std::array<const char*, 6> kNames = {"vessel/surge",       "top_tension",       "tensioner/travel",
                                                 "overbend_von_mises", "sagbend_von_mises", "stinger_tip_clearance"};
  Json out = Json::array();
  for (const char* name : kNames) {
    const HistorySummary* history = find(results, name);
    if (history == nullptr) continue;
    Json trace = entry(*history, "operation", quantity(name, history->units).name, history->over_time, 0.0);
    if (trace.is_null()) continue;
    trace["static"] = nullptr;  // the vessel moves on from there
    out.push_back(std::move(trace));
  }
  return out;
}

Json mooring_history_data(const DynamicResults& results) {
  Json out = Json::array();
  if (results.vessel) add_offsets(results, out);
  for (const MooringLineDynamics& line : results.moorings) {
    const HistorySummary* history = find(results, "mooring/" + line.name + "/fairlead_tension");
    if (history == nullptr) continue;
    Json trace = entry(*history, "moorings", line.name, line.fairlead_tension.whole, line.start_fairlead_tension);
    if (!trace.is_null()) out.push_back(std::move(trace));
  }
  return out;
}

}  // namespace overbend
