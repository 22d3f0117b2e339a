#include "resultfiles/studies/operability_json.h"

namespace overbend {
namespace {

template <class Value>
void put(Json& json, const char* key, const std::optional<Value>& value) {
  if (value) json[key] = *value;
}
template <class Value>
void take(const Json& json, const char* key, std::optional<Value>& value) {
  if (json.contains(key)) value = json.at(key).get<Value>();
}

Json axis_json(const StudyInput& axis) {
  return {{"key", axis.key},   {"unit", axis.unit},         {"show", axis.show},
          {"with", axis.with}, {"words", axis.value_texts}, {"values", axis.values}};
}

StudyInput read_axis(const Json& json) {
  StudyInput axis;
  json.at("key").get_to(axis.key);
  json.at("unit").get_to(axis.unit);
  json.at("show").get_to(axis.show);
  json.at("with").get_to(axis.with);
  json.at("words").get_to(axis.value_texts);
  json.at("values").get_to(axis.values);
  return axis;
}

Json cell_json(const OperabilityCell& cell) {
  Json json = {{"at", cell.value_indices}};
  put(json, "limit", cell.limit);
  json.update({{"beyond", cell.beyond},
               {"decided", cell.decided},
               {"governing", cell.governing},
               {"below", cell.below},
               {"above", cell.above},
               {"runs", cell.runs},
               {"reason", cell.reason}});
  return json;
}

OperabilityCell read_cell(const Json& json) {
  OperabilityCell cell;
  json.at("at").get_to(cell.value_indices);
  take(json, "limit", cell.limit);
  json.at("beyond").get_to(cell.beyond);
  json.at("decided").get_to(cell.decided);
  json.at("governing").get_to(cell.governing);
  json.at("below").get_to(cell.below);
  json.at("above").get_to(cell.above);
  json.at("runs").get_to(cell.runs);
  json.at("reason").get_to(cell.reason);
  return cell;
}

std::optional<Json> workability_json(const std::optional<Workability>& workability) {
  if (!workability) return std::nullopt;
  return Json{{"months", workability->months}, {"year", workability->year}, {"outside", workability->outside}};
}

void take_workability(const Json& json, const char* key, std::optional<Workability>& workability) {
  if (!json.contains(key)) return;
  const Json& read = json.at(key);
  workability = Workability{read.at("months").get<std::vector<double>>(), read.at("year").get<double>(),
                            read.at("outside").get<double>()};
}

}  // namespace

Json operability_json(const OperabilityResults& results) {
  Json json = {{"over", results.over}, {"unit", results.unit}, {"show", results.show}};
  json["axes"] = Json::array();
  for (const StudyInput& axis : results.axes) json["axes"].push_back(axis_json(axis));
  json.update({{"least", results.min_value},
               {"largest", results.max_value},
               {"resolution", results.resolution},
               {"seeds", results.seeds}});
  put(json, "alpha", results.alpha);
  json["cells"] = Json::array();
  for (const OperabilityCell& cell : results.cells) json["cells"].push_back(cell_json(cell));
  put(json, "workability", workability_json(results.workability));
  put(json, "forecast_workability", workability_json(results.forecast_workability));
  json.update({{"runs", results.runs}, {"wall_time", results.wall_time}, {"remarks", results.remarks}});
  return json;
}

OperabilityResults operability_from_json(const Json& json) {
  OperabilityResults results;
  json.at("over").get_to(results.over);
  json.at("unit").get_to(results.unit);
  json.at("show").get_to(results.show);
  for (const Json& axis : json.at("axes")) results.axes.push_back(read_axis(axis));
  json.at("least").get_to(results.min_value);
  json.at("largest").get_to(results.max_value);
  json.at("resolution").get_to(results.resolution);
  json.at("seeds").get_to(results.seeds);
  take(json, "alpha", results.alpha);
  for (const Json& cell : json.at("cells")) results.cells.push_back(read_cell(cell));
  take_workability(json, "workability", results.workability);
  take_workability(json, "forecast_workability", results.forecast_workability);
  json.at("runs").get_to(results.runs);
  json.at("wall_time").get_to(results.wall_time);
  json.at("remarks").get_to(results.remarks);
  return results;
}

}  // namespace overbend
