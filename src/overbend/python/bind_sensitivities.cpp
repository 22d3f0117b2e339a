// Sensitivities of the results of a lay.
#include <pybind11/stl.h>

#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/statics_handle.h"
#include "python/to_python.h"
#include "resultfiles/static/sensitivity_files.h"
#include "statics/solver/unsupported_statics.h"
#include "study/sensitivity/sensitivities.h"

namespace overbend {
namespace {

namespace py = pybind11;

SensitivityResults sensitivities_at(const ModelHandle& model, const std::string& stage,
                                    const SensitivityRequest& request) {
  const Description description = chosen_description(model, stage);
  if (const auto unsupported = missing_pipe_message(description, "sensitivities")) {
    throw std::invalid_argument(*unsupported);
  }
  Model lay = build_model(description);
  const ModelEquilibrium outcome = solve_lay(lay);
  if (outcome.failure) throw SolveError(*outcome.failure);
  std::optional<SensitivityResults> results = find_sensitivities(lay, *outcome.solution, request);
  if (!results) throw EndedRun({RunStatus::no_solution, kNoSensitivities});
  return std::move(*results);
}

/// Returns the sensitivities as in summary.json, and `effects`: the maximum effect of each tolerance in either
/// direction, one row per result.
Json sensitivities_with_effects(const SensitivityResults& results) {
  Json json = sensitivities_json(results);
  Json& effects = json["effects"] = Json::array();
  for (std::size_t r = 0; r < results.results.size(); ++r) {
    Json row = Json::array();
    for (std::size_t i = 0; i < results.inputs.size(); ++i) row.push_back(results.max_effect(r, i));
    effects.push_back(std::move(row));
  }
  return json;
}

}  // namespace

void add_sensitivities(py::module_& module) {
  module.def(
      "sensitivities",
      [](const Given<ModelHandle>& model, const std::string& stage, const std::vector<std::string>& keys,
         bool one_sided) {
        return to_python(sensitivities_with_effects(interruptible([&] {
          return sensitivities_at(*model, stage, {keys, one_sided});
        })));
      },
      py::arg("model"), py::arg("stage"), py::arg("keys"), py::arg("one_sided"),
      "Returns `sensitivities` as in summary.json, and `effects`; for all keys if none are given.");
}

}  // namespace overbend
