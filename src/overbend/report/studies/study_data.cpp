#include "report/studies/study_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "report/page/json_number.h"
#include "report/page/quantity.h"
#include "resultfiles/studies/study_writer.h"

#include "results/result_words.h"
namespace overbend {
namespace {

Json number(const std::optional<double>& value, double factor) {
  return value && std::isfinite(*value) ? json_number(factor * *value) : Json(nullptr);
}

Json input_json(const StudyInput& input) {
  const StudyShown unit = shown_unit_of(input);
  Json values = Json::array();
  for (const double value : input.values) values.push_back(number(value, unit.factor));
  return {
      {"name", heading_of(input.key, unit)}, {"words", input.words}, {"values", values}, {"sampled", input.sampled}};
}

Json outputs_json(const StudyResults& results) {
  Json outputs = Json::array();
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const StudyOutput& output = results.outputs[i];
    if (!output.text) outputs.push_back({{"name", heading_of(output.name, shown_unit_of(output))}, {"at", i}});
  }
  return outputs;
}

const char* state_of(const StudyGroup& group) {
  if (group.done == 0) return group.failed > 0 ? "failed" : "open";
  return word(group.verdict);
}

Json group_json(const StudyResults& results, const StudyGroup& group) {
  Json x = Json::array(), mean = Json::array(), low = Json::array(), high = Json::array();
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const std::vector<double>& inputs = group.first->inputs;
    x.push_back(
        number(i < inputs.size() ? std::optional(inputs[i]) : std::nullopt, shown_unit_of(results.inputs[i]).factor));
  }
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    const double factor = shown_unit_of(results.outputs[i]).factor;
    mean.push_back(number(group.mean[i], factor));
    low.push_back(number(group.low[i], factor));
    high.push_back(number(group.high[i], factor));
  }
  return {{"at", group.first->at},
          {"x", x},
          {"words", group.first->words},
          {"mean", mean},
          {"low", low},
          {"high", high},
          {"state", state_of(group)},
          {"governing", group.governing},
          {"utilisation", number(group.utilisation, 1.0)},
          {"case", group.first->number}};
}

/// Rank correlation of every output with every input that has numbers, of the finished groups.
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
        bars.push_back({{"name", heading_of(results.inputs[i].key, {})}, {"value", json_number(*rho)}});
      }
    }
    all.push_back({{"output", heading_of(results.outputs[o].name, {})}, {"bars", bars}});
  }
  return all;
}

/// Of every output: for every key the values at its ends, the others as in the base.
Json swings(const StudyResults& results, const std::vector<StudyGroup>& groups, std::size_t base) {
  Json all = Json::array();
  for (std::size_t o = 0; o < results.outputs.size(); ++o) {
    if (results.outputs[o].text || !groups[base].mean[o]) continue;
    const StudyShown unit = shown_unit_of(results.outputs[o]);
    Json bars = Json::array();
    for (const std::size_t axis : free_axes(results)) {
      double low = *groups[base].mean[o], high = low;
      std::string low_word = groups[base].first->words.at(axis), high_word = low_word;
      for (const StudyGroup& group : groups) {
        if (!group.mean[o] || group.first->at.at(axis) == groups[base].first->at.at(axis)) continue;
        if (*group.mean[o] < low) {
          low = *group.mean[o];
          low_word = group.first->words.at(axis);
        }
        if (*group.mean[o] > high) {
          high = *group.mean[o];
          high_word = group.first->words.at(axis);
        }
      }
      bars.push_back({{"name", heading_of(results.inputs[axis].key, {})},
                      {"low", json_number(unit.factor * low)},
                      {"high", json_number(unit.factor * high)},
                      {"low_word", low_word},
                      {"high_word", high_word}});
    }
    all.push_back({{"output", heading_of(results.outputs[o].name, unit)},
                   {"base", json_number(unit.factor * *groups[base].mean[o])},
                   {"bars", bars}});
  }
  return all;
}

Json operability_json(const OperabilityResults& operability) {
  const StudyShown unit = shown_unit_of(operability.unit, operability.show);
  Json axes = Json::array(), cells = Json::array();
  for (const StudyInput& axis : operability.axes) axes.push_back(input_json(axis));
  for (const OperabilityCell& cell : operability.cells) {
    cells.push_back({{"at", cell.at},
                     {"limit", number(cell.limit, unit.factor)},
                     {"beyond", cell.beyond},
                     {"decided", cell.decided},
                     {"governing", cell.governing}});
  }
  Json out = {{"over", heading_of(operability.over, unit)},
              {"least", number(operability.least, unit.factor)},
              {"largest", number(operability.largest, unit.factor)},
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

StudyShown shown_unit_of(const std::string& unit, const std::string& show) {
  if (show.empty()) return {};
  const std::string name = unit_of_key(unit, show);
  if (const auto factor = unit_factor(name, unit)) return {name, 1.0 / *factor};
  const ShownUnit usual = shown_unit("", unit);
  return {std::string(usual.name), usual.factor};
}

StudyShown shown_unit_of(const StudyInput& input) {
  return shown_unit_of(input.unit, input.show);
}

StudyShown shown_unit_of(const StudyOutput& output) {
  const ShownUnit unit = shown_output(output);
  return {std::string(unit.name), unit.factor};
}

namespace {

/// Values of keys as the model file has them stay so in the units that it has them in.
void put_words(const StudyInput& input, double value, std::string& words) {
  const StudyShown unit = shown_unit_of(input);
  if (unit.name != input.show && std::isfinite(value)) words = fmt::format("{:.6g} {}", value * unit.factor, unit.name);
}

void put_words(StudyInput& input) {
  for (std::size_t i = 0; i < std::min(input.words.size(), input.values.size()); ++i) {
    put_words(input, input.values[i], input.words[i]);
  }
}

}  // namespace

StudyResults in_shown_units(StudyResults results) {
  for (StudyCase& one : results.cases) {
    for (std::size_t i = 0; i < std::min({one.words.size(), one.inputs.size(), results.inputs.size()}); ++i) {
      put_words(results.inputs[i], one.inputs[i], one.words[i]);
    }
  }
  for (StudyInput& input : results.inputs) put_words(input);
  if (results.operability) {
    for (StudyInput& axis : results.operability->axes) put_words(axis);
  }
  return results;
}

std::string heading_of(const std::string& name, const StudyShown& unit) {
  std::string text = name;
  for (const char* front : {"static.", "dynamic.", "environment."}) {
    if (text.starts_with(front)) text.erase(0, std::string(front).size());
  }
  std::ranges::replace(text, '_', ' ');
  std::size_t bracket = 0;
  for (char& c : text) {  // points within brackets belong to a name
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
