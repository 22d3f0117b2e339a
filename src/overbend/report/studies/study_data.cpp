#include "report/studies/study_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/units.h"
#include "report/page/json_number.h"
#include "report/page/quantity.h"
#include "resultfiles/studies/study_writer.h"

#include "results/result_enum_names.h"
namespace overbend {
namespace {

Json number(const std::optional<double>& value, double factor) {
  return value && std::isfinite(*value) ? json_number(factor * *value) : Json(nullptr);
}

Json input_json(const StudyInput& input) {
  const StudyUnit unit = find_study_unit(input);
  Json values = Json::array();
  for (const double value : input.values) values.push_back(number(value, unit.factor));
  return {{"name", make_heading(input.key, unit)},
          {"words", input.value_texts},
          {"values", values},
          {"sampled", input.sampled}};
}

Json outputs_json(const StudyResults& results) {
  Json outputs = Json::array();
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const StudyOutput& output = results.outputs[i];
    if (!output.text) outputs.push_back({{"name", make_heading(output.name, find_study_unit(output))}, {"at", i}});
  }
  return outputs;
}

const char* group_state(const StudyGroup& group) {
  if (group.done == 0) return group.failed > 0 ? "failed" : "open";
  return word(group.verdict);
}

Json group_json(const StudyResults& results, const StudyGroup& group) {
  Json x = Json::array(), mean = Json::array(), low = Json::array(), high = Json::array();
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const std::vector<double>& inputs = group.first->inputs;
    x.push_back(
        number(i < inputs.size() ? std::optional(inputs[i]) : std::nullopt, find_study_unit(results.inputs[i]).factor));
  }
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const double factor = find_study_unit(results.outputs[i]).factor;
    mean.push_back(number(group.mean[i], factor));
    low.push_back(number(group.low[i], factor));
    high.push_back(number(group.high[i], factor));
  }
  return {{"at", group.first->value_indices},
          {"x", x},
          {"words", group.first->value_texts},
          {"mean", mean},
          {"low", low},
          {"high", high},
          {"state", group_state(group)},
          {"governing", group.governing},
          {"utilisation", number(group.utilisation, 1.0)},
          {"case", group.first->number}};
}

/// Rank correlation of every output with every numerical input, over the finished groups.
Json correlations(const StudyResults& results, const std::vector<StudyGroup>& groups) {
  Json all = Json::array();
  for (std::size_t o = 0; o < results.outputs.size(); ++o) {
    if (results.outputs[o].text) continue;
    Json bars = Json::array();
    for (std::size_t i = 0; i < results.inputs.size(); ++i) {
      std::vector<double> x, y;
      for (const StudyGroup& group : groups) {
        if (!group.mean[o] || i >= group.first->inputs.size() || std::isnan(group.first->inputs[i])) continue;
        x.push_back(group.first->inputs[i]);
        y.push_back(*group.mean[o]);
      }
      if (const auto rho = rank_correlation(x, y)) {
        bars.push_back({{"name", make_heading(results.inputs[i].key, {})}, {"value", json_number(*rho)}});
      }
    }
    all.push_back({{"output", make_heading(results.outputs[o].name, {})}, {"bars", bars}});
  }
  return all;
}

/// For every output and every key: the values at the ends of the key's range, with the other keys as in the base case.
Json swings(const StudyResults& results, const std::vector<StudyGroup>& groups, std::size_t base) {
  Json all = Json::array();
  for (std::size_t o = 0; o < results.outputs.size(); ++o) {
    if (results.outputs[o].text || !groups[base].mean[o]) continue;
    const StudyUnit unit = find_study_unit(results.outputs[o]);
    Json bars = Json::array();
    for (const std::size_t axis : free_axes(results)) {
      double low = *groups[base].mean[o], high = low;
      std::string low_word = groups[base].first->value_texts.at(axis), high_word = low_word;
      for (const StudyGroup& group : groups) {
        if (!group.mean[o] || group.first->value_indices.at(axis) == groups[base].first->value_indices.at(axis)) {
          continue;
        }
        if (*group.mean[o] < low) {
          low = *group.mean[o];
          low_word = group.first->value_texts.at(axis);
        }
        if (*group.mean[o] > high) {
          high = *group.mean[o];
          high_word = group.first->value_texts.at(axis);
        }
      }
      bars.push_back({{"name", make_heading(results.inputs[axis].key, {})},
                      {"low", json_number(unit.factor * low)},
                      {"high", json_number(unit.factor * high)},
                      {"low_word", low_word},
                      {"high_word", high_word}});
    }
    all.push_back({{"output", make_heading(results.outputs[o].name, unit)},
                   {"base", json_number(unit.factor * *groups[base].mean[o])},
                   {"bars", bars}});
  }
  return all;
}

Json operability_json(const OperabilityResults& operability) {
  const StudyUnit unit = find_study_unit(operability.unit, operability.show);
  Json axes = Json::array(), cells = Json::array();
  for (const StudyInput& axis : operability.axes) axes.push_back(input_json(axis));
  for (const OperabilityCell& cell : operability.cells) {
    cells.push_back({{"at", cell.value_indices},
                     {"limit", number(cell.limit, unit.factor)},
                     {"beyond", cell.beyond},
                     {"decided", cell.decided},
                     {"governing", cell.governing}});
  }
  Json out = {{"over", make_heading(operability.over, unit)},
              {"least", number(operability.min_value, unit.factor)},
              {"largest", number(operability.max_value, unit.factor)},
              {"alpha", number(operability.alpha, 1.0)},
              {"axes", axes},
              {"cells", cells}};
  if (operability.workability) {
    out["months"] = Json::array();
    for (const double month : operability.workability->months) out["months"].push_back(json_number(100.0 * month));
    out["year"] = json_number(100.0 * operability.workability->year);
  }
  return out;
}

}  // namespace

StudyUnit find_study_unit(const std::string& unit, const std::string& show) {
  if (show.empty()) return {};
  const std::string name = unit_of_key(unit, show);
  if (const auto factor = unit_factor(name, unit)) return {name, 1.0 / *factor};
  const ShownUnit usual = shown_unit("", unit);
  return {std::string(usual.name), usual.factor};
}

StudyUnit find_study_unit(const StudyInput& input) {
  return find_study_unit(input.unit, input.show);
}

StudyUnit find_study_unit(const StudyOutput& output) {
  const ShownUnit unit = shown_output(output);
  return {std::string(unit.name), unit.factor};
}

namespace {

/// Values are rewritten in the display unit unless this is the unit of the model file.
void convert_value_texts(const StudyInput& input, double value, std::string& text) {
  const StudyUnit unit = find_study_unit(input);
  if (unit.name != input.show && std::isfinite(value)) text = fmt::format("{:.6g} {}", value * unit.factor, unit.name);
}

void convert_value_texts(StudyInput& input) {
  for (std::size_t i = 0; i < std::min(input.value_texts.size(), input.values.size()); ++i) {
    convert_value_texts(input, input.values[i], input.value_texts[i]);
  }
}

}  // namespace

StudyResults convert_to_shown_units(StudyResults results) {
  for (StudyCase& study_case : results.cases) {
    for (std::size_t i = 0;
         i < std::min({study_case.value_texts.size(), study_case.inputs.size(), results.inputs.size()}); ++i) {
      convert_value_texts(results.inputs[i], study_case.inputs[i], study_case.value_texts[i]);
    }
  }
  for (StudyInput& input : results.inputs) convert_value_texts(input);
  if (results.operability) {
    for (StudyInput& axis : results.operability->axes) convert_value_texts(axis);
  }
  return results;
}

std::string make_heading(const std::string& name, const StudyUnit& unit) {
  std::string text = name;
  for (const char* front : {"static.", "dynamic.", "environment."}) {
    if (text.starts_with(front)) text.erase(0, std::string(front).size());
  }
  ranges::replace(text, '_', ' ');
  std::size_t bracket = 0;
  for (char& c : text) {  // dots within brackets belong to a name
    if (c == '[') ++bracket;
    if (c == ']' && bracket > 0) --bracket;
    if (c == '.' && bracket == 0) c = ' ';
  }
  return unit.name.empty() ? text : text + " [" + unit.name + "]";
}

Json study_data(const StudyResults& results) {
  static const char* const kShapes[] = {"single", "curves", "maps", "one_at_a_time", "sample"};
  const StudyShape shape = study_shape(results);
  const std::vector<StudyGroup> groups = study_groups(results);
  Json inputs = Json::array(), all = Json::array();
  for (const StudyInput& input : results.inputs) inputs.push_back(input_json(input));
  for (const StudyGroup& group : groups) all.push_back(group_json(results, group));
  Json data = {{"shape", kShapes[static_cast<int>(shape)]},
               {"inputs", inputs},
               {"outputs", outputs_json(results)},
               {"groups", all},
               {"axes", free_axes(results)}};
  if (shape == StudyShape::sample) data["tornado"] = correlations(results, groups);
  if (const auto base = base_group(results, groups); base && shape == StudyShape::one_at_a_time) {
    data["tornado"] = swings(results, groups, *base);
  }
  if (results.operability) data["operability"] = operability_json(*results.operability);
  return data;
}

}  // namespace overbend
