#include "serve/answers/matrix_json.h"

#include "base/units.h"
#include "report/page/json_number.h"
#include "resultfiles/studies/study_writer.h"

#include "results/result_words.h"
namespace overbend {
namespace {

Json number_json(const std::optional<double>& value, double factor) {
  return value ? Json(json_number(*value * factor)) : Json(nullptr);
}

/// What the SI number of an input is multiplied by to be shown.
double factor_of(const std::string& unit, const std::string& show) {
  return show.empty() || unit.empty() ? 1.0 : 1.0 / unit_factor(show, unit).value_or(1.0);
}

double factor_of(const StudyInput& input) {
  return factor_of(input.unit, input.show);
}

Json input_json(const StudyInput& input) {
  Json values = Json::array();
  for (const double value : input.values) values.push_back(number_json(value, factor_of(input)));
  return {{"key", input.key},         {"unit", input.show},   {"with", input.with},
          {"sampled", input.sampled}, {"words", input.words}, {"values", std::move(values)}};
}

const char* word(StudyCaseState state) {
  return state == StudyCaseState::done ? "done" : state == StudyCaseState::failed ? "failed" : "open";
}

Json case_json(const StudyResults& results, const StudyCase& one) {
  Json inputs = Json::array(), values = Json::array();
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const bool has = i < one.inputs.size();  // not of a case that is still open
    inputs.push_back(has ? Json(json_number(one.inputs[i] * factor_of(results.inputs[i]))) : Json(nullptr));
  }
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    if (results.outputs[i].text) continue;
    const bool has = i < one.values.size();
    values.push_back(has ? number_json(one.values[i], shown_output(results.outputs[i]).factor) : Json(nullptr));
  }
  return {{"number", one.number},
          {"at", one.at},
          {"words", one.words},
          {"inputs", std::move(inputs)},
          {"seed", one.seed ? Json(*one.seed) : Json(nullptr)},
          {"state", word(one.state)},
          {"values", std::move(values)},
          {"verdict", overbend::word(one.verdict)},
          {"passed", one.passed()},
          {"obstacle", one.obstacle()},
          {"governing", one.governing},
          {"utilisation", number_json(one.utilisation, 1.0)},
          {"reason", one.reason}};
}

Json limits_json(const OperabilityResults& limits) {
  const double factor = factor_of(limits.unit, limits.show);
  Json axes = Json::array(), cells = Json::array(), months = Json::array();
  for (const StudyInput& axis : limits.axes) axes.push_back(input_json(axis));
  for (const OperabilityCell& cell : limits.cells) {
    cells.push_back({{"at", cell.at},
                     {"limit", number_json(cell.limit, factor)},
                     {"beyond", cell.beyond},
                     {"decided", cell.decided},
                     {"governing", cell.governing},
                     {"reason", cell.reason}});
  }
  if (limits.workability) {
    for (const double part : limits.workability->months) months.push_back(seven_digits(part));
  }
  return {{"over", limits.over},
          {"unit", limits.show},
          {"alpha", number_json(limits.alpha, 1.0)},
          {"axes", std::move(axes)},
          {"cells", std::move(cells)},
          {"months", std::move(months)},
          {"year", limits.workability ? Json(seven_digits(limits.workability->year)) : Json(nullptr)}};
}

}  // namespace

Json matrix_json(const StudyResults& results) {
  Json inputs = Json::array(), outputs = Json::array(), cases = Json::array();
  for (const StudyInput& input : results.inputs) inputs.push_back(input_json(input));
  for (const StudyOutput& output : results.outputs) {
    if (!output.text) outputs.push_back({{"name", output.name}, {"unit", shown_output(output).name}});
  }
  for (const StudyCase& one : results.cases) cases.push_back(case_json(results, one));
  return {{"title", results.title},
          {"analysis", results.analysis},
          {"inputs", std::move(inputs)},
          {"outputs", std::move(outputs)},
          {"cases", std::move(cases)},
          {"operability", results.operability ? limits_json(*results.operability) : Json(nullptr)},
          {"findings", findings_json(results.findings)}};
}

}  // namespace overbend
