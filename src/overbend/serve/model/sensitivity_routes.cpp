#include "serve/model/sensitivity_routes.h"

#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/yaml_edit.h"
#include "results/fields/sensitivity_texts.h"
#include "serve/model/diagnose.h"
#include "statics/moored/moored_lay.h"
#include "statics/solver/unsupported_statics.h"
#include "study/sensitivity/sensitivities.h"

namespace overbend {
namespace {

constexpr std::size_t kInputs = 12;

Json failed(const std::string& what, const std::string& where, const std::string& why) {
  return {{"status", "failed"}, {"what", what}, {"where", where}, {"why", why}};
}

Json input_json(const SensitivityResults& s, std::size_t result, std::size_t input) {
  const SensitivityInput& parameter = s.inputs[input];
  const double up = s.effect(result, input, 1.0), down = s.effect(result, input, -1.0);
  const double scale = s.max_effect(result, s.most_influential_inputs(result, 1).front());
  return {{"key", parameter.key},
          {"name", parameter.name},
          {"text", parameter.text},
          {"tolerance", tolerance_text(parameter)},
          {"usual", !parameter.own_tolerance},
          {"up", up / scale},
          {"down", down / scale},
          {"up_text", result_text(s.results[result], up, true)},
          {"down_text", result_text(s.results[result], down, true)},
          {"contact", contact_text(parameter, s.at(result, input))}};
}

Json sensitivities_answer_json(const SensitivityResults& s) {
  Json results = Json::array();
  for (std::size_t r = 0; r < s.results.size(); ++r) {
    if (!s.results[r].key) continue;
    Json inputs = Json::array();
    for (const std::size_t i : s.most_influential_inputs(r, kInputs)) inputs.push_back(input_json(s, r, i));
    results.push_back({{"name", s.results[r].name},
                       {"text", s.results[r].text},
                       {"value", result_text(s.results[r], s.results[r].value, false)},
                       {"inputs", std::move(inputs)}});
  }
  return {{"status", "converged"},
          {"results", std::move(results)},
          {"assumptions", texts(s.assumptions)},
          {"elapsed_ms", 1e3 * s.wall_time}};
}

std::string edited(const ModelText& model, const std::vector<YamlChange>& changes) {
  try {
    return edit_yaml(model.text, changes);
  } catch (const YamlEditError& error) {
    throw HttpError(422, error.what());
  }
}

}  // namespace

Json sensitivities_answer(const ModelText& model, const std::vector<YamlChange>& changes) {
  const std::string text = edited(model, changes);
  const ModelReading reading = read_model_text(text, model.path);
  if (!reading.description) {
    return {{"status", "invalid"}, {"diagnostics", diagnostics_json(reading, text)}};
  }
  if (const auto unsupported = missing_pipe_message(*reading.description, "sensitivities")) {
    return failed("no sensitivities", "", *unsupported);
  }
  Model lay = build_model(*reading.description);
  const ModelEquilibrium outcome = solve_lay(lay);
  if (outcome.failure) return failed(outcome.failure->what, outcome.failure->where, outcome.failure->why);
  const auto found = find_sensitivities(lay, *outcome.solution);
  return found ? sensitivities_answer_json(*found) : failed("no sensitivities", "", kNoSensitivities);
}

void add_sensitivity_routes(std::vector<HttpRoute>& routes, OpenModel& model) {
  routes.push_back({"POST", "/api/sensitivities",
                    [&](const HttpRequest& request) {
                      return json_answer(sensitivities_answer(
                          model.snapshot(), read_changes(request.json().value("changes", Json::array()))));
                    },
                    kLongLimit});
}

}  // namespace overbend
