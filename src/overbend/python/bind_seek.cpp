// Goal seek: what is wanted comes as the key `seek` of a model file.
#include "base/file_lock.h"
#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/operation_handle.h"
#include "python/statics_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"
#include "resultfiles/studies/seek_writer.h"
#include "study/goal_seek/seek_run.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// What was found, with the model and the statics of the answer.
struct SoughtHandle {
  SeekRun run;
  Description description;
  std::shared_ptr<ModelHandle> answer;
  std::shared_ptr<StaticsHandle> statics;
  std::shared_ptr<OperationHandle> operation;  ///< Of a lift, in place of the statics.
};

/// What was given here stands on no line of the model's file.
Diagnostics without_lines(const Diagnostics& found) {
  Diagnostics told;
  for (Diagnostic one : found.sorted()) {
    if (one.key.starts_with("seek")) {
      one.file.clear();
      one.line = one.column = 0;
    }
    told.add(std::move(one));
  }
  return told;
}

/// The model with the key put in; with an empty text its own.
Description asked_seek(const ModelHandle& model, const std::string& wanted) {
  if (wanted.empty()) return model.description();
  ModelReading reading =
      read_model_text(edit_yaml(model.text(), {{"seek", YamlChange::Kind::flow, wanted}}), model.file());
  if (!reading.description) throw UnreadableModel(without_lines(reading.diagnostics));
  return std::move(*reading.description);
}

std::shared_ptr<SoughtHandle> sought(const ModelHandle& model, const std::string& wanted,
                                     const std::function<bool()>& stop) {
  auto found = std::make_shared<SoughtHandle>();
  found->description = asked_seek(model, wanted);
  const std::optional<SeekDescription> seek = read_seek(found->description);
  if (!seek) throw SeekFault("seek: the model has no key seek, expected vary and until");
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

using GivenSought = Given<SoughtHandle>;

std::shared_ptr<SoughtHandle> seek_of(const Given<ModelHandle>& model, const std::string& wanted) {
  std::shared_ptr<SoughtHandle> found;
  std::atomic<bool> stop = false;
  work_beside([&] { found = sought(*model, wanted, [&] { return stop.load(); }); }, stop, {});
  return found;
}

void save_seek(const GivenSought& found, const std::string& folder) {
  const std::lock_guard hold(hdf5_lock());
  write_seek_run(found->run, found->description, folder);
}

}  // namespace

void add_seek(py::module_& module) {
  py::class_<SoughtHandle, std::shared_ptr<SoughtHandle>>(module, "Sought", "What a goal seek found.")
      .def_property_readonly("results",
                             [](const GivenSought& found) { return to_python(seek_json(found->run.results)); })
      .def_property_readonly("model", [](const GivenSought& found) { return found->answer; })
      .def_property_readonly("statics", [](const GivenSought& found) { return found->statics; })
      .def_property_readonly("operation", [](const GivenSought& found) { return found->operation; })
      .def("save", &save_seek, py::arg("folder"));
  module.def("seek", &seek_of, py::arg("model"), py::arg("wanted"),
             "Searches for what the text in YAML's flow style says as the key `seek`; empty: the model's own.");
}

}  // namespace overbend
