#include "report/studies/comparison_data.h"

#include <algorithm>

#include "report/dynamic/history_data.h"
#include "report/page/json_number.h"
#include "resultfiles/studies/comparison_writer.h"
#include "resultfiles/studies/seeds_writer.h"

namespace overbend {
namespace {

Json numbers(const std::vector<double>& values, double factor = 1.0) {
  Json out = Json::array();
  for (const double value : values) out.push_back(json_number(factor * value));
  return out;
}

Json make_trace(const DynamicResults& results, const std::string& name) {
  const auto found = std::find_if(results.histories.begin(), results.histories.end(),
                                  [&](const HistorySummary& history) { return history.name == name; });
  return found == results.histories.end() ? Json(nullptr) : history_trace(*found, quantity(found->name, found->units));
}

Json tensioner_run(const ComparedRun& run) {
  Json states = Json::array();
  for (const TensionerSpan& span : run.states) {
    states.push_back(Json::array({json_number(span.from), json_number(span.to), span.state}));
  }
  return {{"name", run.name},
          {"tension", make_trace(run.results, "tensioner/tension")},
          {"travel", make_trace(run.results, "tensioner/travel")},
          {"states", states},
          {"close",
           {{"time", numbers(run.close.time)},
            {"tension", numbers(run.close.tension, shown_unit("N").factor)},
            {"travel", numbers(run.close.travel, shown_unit("m").factor)}}}};
}

Json box_run(const ComparedBox& box) {
  Json out = {{"row_contact_share", numbers(box.row_share)}, {"row_peak_force", numbers(box.row_peak)}};
  for (const BoxQuantity& rule : box_quantities()) out[rule.quantity.name] = json_number(box.*(rule.value));
  return out;
}

Json tensioner_data(const Comparison& comparison) {
  Json runs = Json::array();
  for (const ComparedRun& run : comparison.runs) runs.push_back(tensioner_run(run));
  const TensionerDynamics& t = comparison.runs.front().results.tensioner;
  const bool ranged = t.range_high > t.range_low;
  return {{"range", ranged ? numbers({t.range_low, t.range_high}, shown_unit("N").factor) : Json(nullptr)},
          {"limit", t.travel_limit > 0.0 ? json_number(t.travel_limit * shown_unit("m").factor) : Json(nullptr)},
          {"runs", runs}};
}

Json contact_data(const Comparison& comparison) {
  Json runs = Json::array(), boxes = Json::array();
  for (const ComparedRun& run : comparison.runs) runs.push_back({{"name", run.name}, {"words", run.label}});
  for (const ComparedBoxes& box : comparison.boxes) {
    Json seen = Json::array();
    for (const ComparedBox& compared : box.runs) seen.push_back(box_run(compared));
    boxes.push_back({{"name", box.name}, {"runs", seen}});
  }
  Json shown = Json::object();
  for (const BoxQuantity& rule : box_quantities()) {
    const ShownUnit unit = table_unit(rule.quantity);
    shown[rule.quantity.name] = {{"unit", unit.name}, {"factor", unit.factor}, {"digits", unit.digits}};
  }
  return {{"runs", runs}, {"boxes", boxes}, {"shown", shown}};
}

}  // namespace

Json comparison_data(const Comparison& comparison) {
  const bool tensioner = comparison.of == ComparisonType::tensioner;
  Json data = tensioner ? tensioner_data(comparison) : contact_data(comparison);
  data["of"] = enum_name(comparison.of);
  data["duration"] = json_number(comparison.duration);
  data["build_up"] = json_number(comparison.build_up);
  data["close_from"] = json_number(comparison.detail_start);
  return data;
}

}  // namespace overbend
