// Operations with their stages.
#include <pybind11/stl.h>

#include <mutex>

#include "base/file_lock.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/operation_handle.h"
#include "python/python_errors.h"
#include "python/statics_handle.h"
#include "python/to_python.h"
#include "resultfiles/stages/operation_reader.h"
#include "resultfiles/stages/operation_writer.h"
#include "resultfiles/static/case_summary.h"
#include "resultfiles/summary/result_objects.h"
#include "resultfiles/summary/summary_json.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// Progress of the stages, for the waiting thread.
class StageWatch {
 public:
  bool count_stage(const StageResult& stage, std::size_t total) {
    const std::lock_guard<std::mutex> hold(mutex_);
    ++done_;
    of_ = total;
    name_ = stage.stage.name;
    return !stopped;
  }
  /// Calls progress(stages done, stages, name of the last one).
  void report_progress(const py::object& progress) {
    if (progress.is_none()) return;
    std::unique_lock<std::mutex> hold(mutex_);
    if (done_ == 0) return;
    const std::size_t done = done_, of = of_;
    const std::string name = name_;
    hold.unlock();
    progress(done, of, name);
  }

  std::atomic<bool> stopped = false;

 private:
  std::mutex mutex_;
  std::size_t done_ = 0, of_ = 0;
  std::string name_;
};

using GivenOperation = Given<OperationHandle>;

std::shared_ptr<OperationHandle> solved_stages(const Given<ModelHandle>& model, const py::object& progress) {
  auto found = std::make_shared<OperationHandle>(OperationHandle{model.shared(), {}});
  StageWatch watch;
  const auto solve = [&] {
    const Description& description = model->description();
    if (!is_lay_operation(description.operation.type)) {
      throw std::invalid_argument("the model has no operation on the line: set operation.type and operation.stages");
    }
    found->results = solve_operation(
        description, [&](const StageResult& stage, std::size_t total) { return watch.count_stage(stage, total); });
  };
  run_in_background(solve, watch.stopped, [&] { watch.report_progress(progress); });
  return found;
}

std::shared_ptr<OperationHandle> stored_operation(const std::string& h5) {
  StoredOperation read = reading_results([&] { return read_operation_results(h5); });
  return std::make_shared<OperationHandle>(
      OperationHandle{ModelHandle::from_text(read.model_text, read.model_file), std::move(read.results)});
}

std::shared_ptr<ResultTree> make_operation_tree(const GivenOperation& operation) {
  auto tree = std::make_shared<ResultTree>();
  write_operation_groups(*tree, operation->results);
  return tree;
}

/// Returns the statics of a stage; null if it has no equilibrium.
std::shared_ptr<StaticsHandle> find_stage(const GivenOperation& operation, std::size_t number) {
  const std::vector<StageResult>& stages = operation->results.stages;
  const StageResult& stage = stages[checked_index(number, stages.size(), "stages")];
  if (!stage.lay) return nullptr;
  StaticRun statics;
  statics.results = stage.lay;
  return std::make_shared<StaticsHandle>(operation->model, stage.stage.name, std::move(statics));
}

void save_operation(const GivenOperation& operation, const std::string& folder) {
  const std::lock_guard hold(hdf5_lock());
  write_operation_run(operation->results, operation->model->description(), folder);
}

}  // namespace

void add_operations(py::module_& module) {
  py::class_<OperationHandle, std::shared_ptr<OperationHandle>>(module, "Operation",
                                                                "Results of the stages of an operation.")
      .def(py::init(&solved_stages), py::arg("model"), py::arg("progress") = py::none())
      .def_static("stored", &stored_operation, py::arg("h5"), "From results.h5.")
      .def_property_readonly("model", [](const GivenOperation& operation) { return operation->model; })
      .def("summary",
           [](const GivenOperation& operation) {
             return to_python(with_objects(operation_summary_json(operation->results)));
           })
      .def("tree", &make_operation_tree)
      .def("stage", &find_stage, py::arg("number"),
           "Returns the statics of a stage, numbered from 0; None if it has no equilibrium.")
      .def("save", &save_operation, py::arg("folder"));
  module.def(
      "has_operation", [](const std::string& h5) { return reading_results([&] { return has_lay_operation(h5); }); },
      py::arg("h5"));
}

}  // namespace overbend
