// What the results of a lay hang on.
#include <pybind11/stl.h>

#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/statics_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"
#include "resultfiles/static/sensitivity_files.h"
#include "statics/solver/static_obstacle.h"
#include "study/sensitivity/sensitivities.h"

namespace overbend {
namespace {

namespace py = pybind11;

SensitivityResults sensitivities_at(const ModelHandle& model, const std::string& stage, const SensitivityWish& wish) {
  const Description description = chosen_description(model, stage);
  if (const auto obstacle = pipe_obstacle(description, "sensitivities")) throw std::invalid_argument(*obstacle);
  Model lay = build_model(description);
  const ModelEquilibrium outcome = solve_lay(lay);
  if (outcome.failure) throw SolveFault(*outcome.failure);
  std::optional<SensitivityResults> results = find_sensitivities(lay, *outcome.solution, wish);
  if (!results) throw EndedRun({RunEnding::no_solution, kNoSensitivities});
  return std::move(*results);
}

/// As summary.json, with the effects of the tolerances beside: the largest either way, row by row of the results.
Json told_sensitivities(const SensitivityResults& results) {
  Json json = sensitivities_json(results);
  Json& effects = json["effects"] = Json::array();
  for (std::size_t r = 0; r < results.results.size(); ++r) {
    Json row = Json::array();
    for (std::size_t i = 0; i < results.inputs.size(); ++i) row.push_back(results.largest_effect(r, i));
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
        return to_python(told_sensitivities(interruptible([&] {
          return sensitivities_at(*model, stage, {keys, one_sided});
        })));
      },
      py::arg("model"), py::arg("stage"), py::arg("keys"), py::arg("one_sided"),
      "As summary.json's `sensitivities`, and `effects`; all keys where none are given.");
}

}  // namespace overbend
