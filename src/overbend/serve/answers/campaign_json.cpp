#include "serve/answers/campaign_json.h"

#include "base/units.h"
#include "report/page/json_number.h"
#include "resultfiles/studies/study_writer.h"

#include "results/result_enum_names.h"
namespace overbend {
namespace {

Json number_json(const std::optional<double>& value, double factor) {
  return value ? Json(json_number(*value * factor)) : Json(nullptr);
}

/// Returns the factor from SI to the unit shown.
double input_factor(const std::string& unit, const std::string& show) {
  return show.empty() || unit.empty() ? 1.0 : 1.0 / unit_factor(show, unit).value_or(1.0);
}

double input_factor(const StudyInput& input) {
  return input_factor(input.unit, input.show);
}

Json input_json(const StudyInput& input) {
  Json values = Json::array();
  for (const double value : input.values) values.push_back(number_json(value, input_factor(input)));
  return {{"key", input.key},         {"unit", input.show},         {"with", input.with},
          {"sampled", input.sampled}, {"words", input.value_texts}, {"values", std::move(values)}};
}

const char* word(StudyCaseState state) {
  return state == StudyCaseState::done ? "done" : state == StudyCaseState::failed ? "failed" : "open";
}

Json case_json(const StudyResults& results, const StudyCase& study_case) {
  Json inputs = Json::array(), values = Json::array();
  for (std::size_t i = 0; i < results.inputs.size(); ++i) {
    const bool has = i < study_case.inputs.size();  // cases not yet run have no inputs
    inputs.push_back(has ? Json(json_number(study_case.inputs[i] * input_factor(results.inputs[i]))) : Json(nullptr));
  }
  for (std::size_t i = 0; i < results.outputs.size(); ++i) {
    if (results.outputs[i].text) continue;
    const bool has = i < study_case.values.size();
    values.push_back(has ? number_json(study_case.values[i], shown_output(results.outputs[i]).factor) : Json(nullptr));
  }
  return {{"number", study_case.number},
          {"at", study_case.value_indices},
          {"words", study_case.value_texts},
          {"inputs", std::move(inputs)},
          {"seed", study_case.seed ? Json(*study_case.seed) : Json(nullptr)},
          {"state", word(study_case.state)},
          {"values", std::move(values)},
          {"verdict", overbend::word(study_case.verdict)},
          {"passed", study_case.passed()},
          {"obstacle", study_case.failure_reason()},
          {"governing", study_case.governing},
          {"utilisation", number_json(study_case.utilisation, 1.0)},
          {"reason", study_case.reason}};
}

Json limits_json(const OperabilityResults& limits) {
  const double factor = input_factor(limits.unit, limits.show);
  Json axes = Json::array(), cells = Json::array(), months = Json::array();
  for (const StudyInput& axis : limits.axes) axes.push_back(input_json(axis));
  for (const OperabilityCell& cell : limits.cells) {
    cells.push_back({{"at", cell.value_indices},
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

Json campaign_json(const StudyResults& results) {
  Json inputs = Json::array(), outputs = Json::array(), cases = Json::array();
  for (const StudyInput& input : results.inputs) inputs.push_back(input_json(input));
  for (const StudyOutput& output : results.outputs) {
    if (!output.text) outputs.push_back({{"name", output.name}, {"unit", shown_output(output).name}});
  }
  for (const StudyCase& study_case : results.cases) cases.push_back(case_json(results, study_case));
  return {{"title", results.title},
          {"analysis", results.analysis},
          {"inputs", std::move(inputs)},
          {"outputs", std::move(outputs)},
          {"cases", std::move(cases)},
          {"operability", results.operability ? limits_json(*results.operability) : Json(nullptr)},
          {"findings", findings_json(results.findings)}};
}

}  // namespace overbend
