#include "resultfiles/summary/named_results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/result_path.h"
#include "resultfiles/summary/lift_units.h"
#include "resultfiles/summary/named_dynamics.h"
#include "resultfiles/summary/pull_units.h"
#include "resultfiles/summary/result_units.h"
#include "results/fields/object_names.h"

namespace overbend {
namespace {

constexpr std::array<std::pair<const char*, ResultFunction>, 4> kFunctions = {{{"spread", ResultFunction::spread},
                                                                               {"mean", ResultFunction::mean},
                                                                               {"min", ResultFunction::minimum},
                                                                               {"max", ResultFunction::maximum}}};

bool is_selected(const Json& item, std::size_t index, const std::string& text) {
  const auto name = item.is_object() ? item.find("name") : item.end();
  const std::string item_name =
      item.is_object() && name != item.end() && name->is_string() ? name->get<std::string>() : "";
  return chooses_item(text, index, item_name);
}

void gather(const Json& json, const std::vector<PathPart>& parts, std::size_t next, std::vector<double>& values) {
  if (next == parts.size()) {
    if (json.is_number()) values.push_back(json.get<double>());
    return;
  }
  const PathPart& part = parts[next];
  if (part.item && json.is_array()) {
    for (std::size_t i = 0; i < json.size(); ++i) {
      if (is_selected(json[i], i, part.text)) gather(json[i], parts, next + 1, values);
    }
  } else if (part.item && json.is_object()) {  // objects by name, such as the lines of a lift
    for (const auto& [name, below] : json.items()) {
      if (matches_pattern(part.text, name)) gather(below, parts, next + 1, values);
    }
  } else if (!part.item && json.is_object()) {
    const auto found = json.find(part.text);
    if (found != json.end()) gather(*found, parts, next + 1, values);
  }
}

double compute_mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double compute_deviation(const std::vector<double>& values) {
  const double mean = compute_mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

double apply(ResultFunction function, const std::vector<double>& values) {
  switch (function) {
    case ResultFunction::spread:
      return compute_deviation(values);
    case ResultFunction::mean:
      return compute_mean(values);
    case ResultFunction::minimum:
      return *std::min_element(values.begin(), values.end());
    case ResultFunction::maximum:
      return *std::max_element(values.begin(), values.end());
    case ResultFunction::none:
      break;
  }
  return values.front();
}

/// Returns the entry of the path in the table of units; null without one. "*" stands for any name.
const Json* unit_at(const Json& table, const std::vector<PathPart>& parts) {
  const Json* node = &table;
  for (const PathPart& part : parts) {
    if (node->is_array()) {
      if (!part.item || node->empty()) return nullptr;
      node = &node->front();
      continue;
    }
    const bool any = node->is_object() && node->contains("*");
    if (!node->is_object() || (part.item && !any)) return nullptr;
    const auto found = node->find(any ? "*" : part.text);
    if (found == node->end()) return nullptr;
    node = &*found;
  }
  return node->is_string() ? node : nullptr;
}

Json units_of_stages(Json stage) {
  stage["checks"] = summary_units().at("checks");
  return Json{{"operation", {{"stages", Json::array({std::move(stage)})}}}};
}

const Json& lift_units() {
  static const Json kUnits = units_of_stages(lift_stage_units());
  return kUnits;
}

const Json& pull_units() {
  static const Json kUnits = units_of_stages(pull_stage_units(summary_units().at("static")));
  return kUnits;
}

void list_paths(const Json& json, const std::string& path, std::vector<std::string>& paths) {
  if (json.is_string()) paths.push_back(path);
  if (json.is_array() && !json.empty()) list_paths(json.front(), path + "[]", paths);
  if (!json.is_object()) return;
  if (json.contains("*")) return list_paths(json.at("*"), path + "[]", paths);
  for (const auto& [key, below] : json.items()) {
    std::string deeper = path.empty() ? "" : path + ".";
    list_paths(below, deeper.append(key), paths);
  }
}

std::optional<std::string> find_unit(const Json& units, const std::string& name) {
  for (const std::string& path : summary_paths(parsed_result_name(name).path)) {
    const auto parts = split_result_path(path);
    if (const Json* unit = parts ? unit_at(units, *parts) : nullptr) return unit->get<std::string>();
  }
  return std::nullopt;
}

/// Returns the paths by kind, then by object.
std::vector<std::string> collect_paths(const Json& units) {
  std::vector<std::string> paths;
  list_paths(units, "", paths);
  for (std::size_t i = 0, count = paths.size(); i < count; ++i) {
    if (std::optional<std::string> object = object_path(paths[i])) paths.push_back(std::move(*object));
  }
  return paths;
}

}  // namespace

ResultName parsed_result_name(const std::string& name) {
  for (const auto& [word, function] : kFunctions) {
    const std::string head = std::string(word) + "(";
    if (name.starts_with(head) && name.ends_with(')')) {
      return {function, name.substr(head.size(), name.size() - head.size() - 1)};
    }
  }
  return {ResultFunction::none, name};
}

std::vector<double> named_values(const Json& summary, const std::string& path) {
  std::vector<double> values;
  for (const std::string& name : summary_paths(path)) {
    if (const auto parts = split_result_path(name)) gather(summary, *parts, 0, values);
  }
  return values;
}

std::optional<double> named_result(const Json& summary, const std::string& name) {
  const ResultName parsed = parsed_result_name(name);
  const std::vector<double> values = named_values(summary, parsed.path);
  if (values.empty() || (parsed.function == ResultFunction::none && values.size() > 1)) return std::nullopt;
  return apply(parsed.function, values);
}

std::optional<std::string> result_unit(const std::string& name) {
  for (const Json* units : {&summary_units(), &lift_units(), &pull_units()}) {
    if (std::optional<std::string> unit = find_unit(*units, name)) return unit;
  }
  return std::nullopt;
}

std::vector<std::string> result_paths() {
  std::vector<std::string> paths = collect_paths(summary_units());
  list_paths(lift_units(), "", paths);
  list_paths(pull_units(), "", paths);
  return paths;
}

std::optional<std::string> dynamic_result_unit(const std::string& name) {
  return find_unit(dynamic_summary_units(), name);
}

std::vector<std::string> dynamic_result_paths() {
  return collect_paths(dynamic_summary_units());
}

}  // namespace overbend
