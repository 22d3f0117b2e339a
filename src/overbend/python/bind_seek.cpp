// Goal seek, specified like the key `seek` of a model file.
#include "base/file_lock.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/operation_handle.h"
#include "python/statics_handle.h"
#include "python/to_python.h"
#include "resultfiles/studies/seek_writer.h"
#include "study/goal_seek/seek_run.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// Result of a goal seek, with model and statics of the solution.
struct GoalSeekHandle {
  SeekRun run;
  Description description;
  std::shared_ptr<ModelHandle> answer;
  std::shared_ptr<StaticsHandle> statics;
  std::shared_ptr<OperationHandle> operation;  ///< Stages of a lift, instead of the statics.
};

/// Removes file and line from diagnostics of the key `seek`, which is not in the model file.
Diagnostics without_lines(const Diagnostics& found) {
  Diagnostics kept;
  for (Diagnostic diagnostic : found.sorted()) {
    if (diagnostic.key.starts_with("seek")) {
      diagnostic.file.clear();
      diagnostic.line = diagnostic.column = 0;
    }
    kept.add(std::move(diagnostic));
  }
  return kept;
}

/// Returns the model with the key `seek` set to `wanted`; unchanged if `wanted` is empty.
Description description_with_seek(const ModelHandle& model, const std::string& wanted) {
  if (wanted.empty()) return model.description();
  ModelReading reading =
      read_model_text(edit_yaml(model.text(), {{"seek", YamlChange::Kind::flow, wanted}}), model.file());
  if (!reading.description) throw UnreadableModel(without_lines(reading.diagnostics));
  return std::move(*reading.description);
}

std::shared_ptr<GoalSeekHandle> run_goal_seek(const ModelHandle& model, const std::string& wanted,
                                              const std::function<bool()>& stop) {
  auto found = std::make_shared<GoalSeekHandle>();
  found->description = description_with_seek(model, wanted);
  const std::optional<SeekDescription> seek = read_seek(found->description);
  if (!seek) throw SeekError("seek: the model has no key seek; expected a key seek with vary and until");
  found->run = run_seek(found->description, *seek, stop);
  if (!found->run.results.found) return found;
  found->answer = model.changed(answer_changes(found->description, *seek, found->run.results));
  if (found->run.operation) {
    found->operation = std::make_shared<OperationHandle>(OperationHandle{found->answer, *found->run.operation});
    return found;
  }
  found->statics = std::make_shared<StaticsHandle>(found->answer, "", found->run.statics);
  return found;
}

using GivenGoalSeek = Given<GoalSeekHandle>;

std::shared_ptr<GoalSeekHandle> seek_in_background(const Given<ModelHandle>& model, const std::string& wanted) {
  std::shared_ptr<GoalSeekHandle> found;
  std::atomic<bool> stop = false;
  run_in_background([&] { found = run_goal_seek(*model, wanted, [&] { return stop.load(); }); }, stop, {});
  return found;
}

void save_seek(const GivenGoalSeek& found, const std::string& folder) {
  const std::lock_guard hold(hdf5_lock());
  write_seek_run(found->run, found->description, folder);
}

}  // namespace

void add_seek(py::module_& module) {
  py::class_<GoalSeekHandle, std::shared_ptr<GoalSeekHandle>>(module, "Sought", "Result of a goal seek.")
      .def_property_readonly("results",
                             [](const GivenGoalSeek& found) { return to_python(seek_json(found->run.results)); })
      .def_property_readonly("model", [](const GivenGoalSeek& found) { return found->answer; })
      .def_property_readonly("statics", [](const GivenGoalSeek& found) { return found->statics; })
      .def_property_readonly("operation", [](const GivenGoalSeek& found) { return found->operation; })
      .def("save", &save_seek, py::arg("folder"));
  module.def("seek", &seek_in_background, py::arg("model"), py::arg("wanted"),
             "Runs the goal seek given as the key `seek` in YAML flow style; empty: the key of the model.");
}

}  // namespace overbend
