#include "report/moored/line_data.h"

#include <algorithm>

#include "report/dynamic/history_data.h"
#include "report/page/json_number.h"

namespace overbend {
namespace {

Json node_data(const LineResult& line) {
  Json s = Json::array(), places = Json::array(), tension = Json::array(), least = Json::array(),
       largest = Json::array();
  for (const LineNodeResult& node : line.nodes) {
    s.push_back(json_number(node.s));
    places.push_back({json_number(node.place.x()), json_number(node.place.y()), json_number(node.place.z())});
    tension.push_back(json_number(node.tension));
    least.push_back(json_number(node.least_tension));
    largest.push_back(json_number(node.largest_tension));
  }
  return {{"name", line.name},  {"s", s},         {"places", places},
          {"tension", tension}, {"least", least}, {"largest", largest}};
}

/// Of one end, in the form of the other histories.
Json end_history(const LineResult& line, const char* which, const LineEndResult& end,
                 const std::vector<double>& values) {
  HistorySummary history;
  history.name = "tension";
  history.units = "N";
  history.low = values;
  history.high = values;
  const Quantity q = quantity(history.name, history.units);
  Json trace = history_trace(history, q);
  if (trace.is_null()) return trace;
  trace.update({{"group", "ends"},
                {"title", line.name + ", tension at the " + which + " end"},
                {"unit", q.unit},
                {"digits", q.digits},
                {"over_time",
                 {{"min", json_number(q.shown(end.in_time.min))},
                  {"max", json_number(q.shown(end.in_time.max))},
                  {"mean", json_number(q.shown(end.in_time.mean))},
                  {"std", json_number(q.shown(end.in_time.std))}}},
                {"static", json_number(q.shown(end.tension))}});
  return trace;
}

Json dynamic_data(const LinesResults& results) {
  Json histories = Json::array();
  for (const LineResult& line : results.lines) {
    for (Json trace : {end_history(line, "first", line.first, line.first_history),
                       end_history(line, "second", line.second, line.second_history)}) {
      if (!trace.is_null()) histories.push_back(std::move(trace));
    }
  }
  return {{"duration", json_number(duration_of(results))},
          {"build_up", json_number(build_up_of(results))},
          {"histories", std::move(histories)},
          {"spectra", Json::array()}};
}

}  // namespace

double build_up_of(const LinesResults& results) {
  return results.time.empty() ? 0.0 : std::max(0.0, -results.time.front());
}

double duration_of(const LinesResults& results) {
  return results.time.empty() ? 0.0 : results.time.back();
}

Json line_figure_data(const LinesResults& results, double water_depth) {
  Json lines = Json::array();
  for (const LineResult& line : results.lines) lines.push_back(node_data(line));
  Json data = {{"lines", std::move(lines)}, {"moved", results.moved}, {"water_depth", json_number(water_depth)}};
  if (results.moved) data["dynamic"] = dynamic_data(results);
  return data;
}

}  // namespace overbend
