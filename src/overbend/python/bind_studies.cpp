// Studies of many cases written to folders.
#include <algorithm>

#include "base/ranges.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/study_handle.h"
#include "python/to_python.h"
#include "resultfiles/hdf5/result_tree.h"
#include "resultfiles/studies/operability_json.h"
#include "resultfiles/studies/study_writer.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_execution.h"

namespace overbend {
namespace {

namespace py = pybind11;

struct StudyOptions {
  int threads = 0;
  bool retry_failed = false;
  double checkpoint_every = 60.0;
};

using GivenStudy = Given<StudyHandle>;

/// Runs the study. Returns true if it was interrupted before its end.
bool run_to_end(const GivenStudy& study, const std::string& folder, const StudyOptions& conduct,
                const py::object& progress) {
  CaseCounter count;
  bool interrupted = false;
  const auto work = [&] {
    study->open(folder);
    StudyRunOptions options{.threads = conduct.threads, .retry_failed = conduct.retry_failed};
    options.checkpoint_every = conduct.checkpoint_every;
    const StudyExecution outcome = execute_study(study->base(), folder, options, count);
    interrupted = outcome.ending == RunStatus::interrupted;
    if (outcome.ending != RunStatus::done && !interrupted) throw UnusableFolder(outcome.why);
  };
  const auto report = [&] {
    const CaseCounter::Tally tally = count.tally();
    if (!progress.is_none() && tally.done > 0) progress(tally.done, tally.cases, tally.failed);
  };
  try {
    run_in_background(work, count.stopped, report);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_KeyboardInterrupt)) throw;
    interrupted = true;
  }
  return interrupted;
}

/// Runs a single case with all its files. Returns its folder within that of the study.
std::string run_one(const GivenStudy& study, const std::string& folder, std::size_t number) {
  checked_index(number, study->cases().count(), "cases");
  StudyCase study_case;
  std::atomic<bool> stop = false;
  const auto work = [&] {
    study->open(folder);
    study_case = run_study_case(study->base(), study->cases(), folder, number, [&] { return stop.load(); });
  };
  run_in_background(work, stop, {});
  if (study_case.state == StudyCaseState::failed) throw EndedRun({RunStatus::no_solution, study_case.reason});
  return study_case.folder;
}

std::shared_ptr<StudyResults> read_so_far(const std::string& folder) {
  return reading_results([&] { return std::make_shared<StudyResults>(study_so_far(folder)); });
}

std::shared_ptr<ResultTree> make_study_tree(const Given<StudyResults>& results) {
  auto tree = std::make_shared<ResultTree>();
  write_study_groups(*tree, *results);
  return tree;
}

/// Returns the columns of the table and the results of an operability search.
Json study_tables_json(const StudyResults& results) {
  Json inputs = Json::array(), outputs = Json::array();
  for (const StudyInput& input : results.inputs) {
    inputs.push_back({{"key", input.key},
                      {"unit", input.unit},
                      {"with", input.with},
                      {"sampled", input.sampled},
                      {"words", input.value_texts},
                      {"values", input.values}});
  }
  for (const StudyOutput& output : results.outputs) {
    outputs.push_back({{"name", output.name}, {"unit", output.unit}, {"text", output.text}});
  }
  const auto seeds = ranges::count_if(results.cases, [](const StudyCase& study_case) { return study_case.group == 0; });
  return {{"title", results.title},
          {"version", results.version},
          {"analysis", results.analysis},
          {"inputs", inputs},
          {"outputs", outputs},
          {"seeds", seeds},
          {"warnings", messages(results.findings)},
          {"findings", findings_json(results.findings)},
          {"assumptions", texts(results.assumptions)},
          {"wall_time", results.wall_time},
          {"command", results.command},
          {"operability", results.operability ? operability_json(*results.operability) : Json(nullptr)}};
}

}  // namespace

void add_studies(py::module_& module) {
  py::class_<StudyHandle, std::shared_ptr<StudyHandle>>(module, "Study", "The cases of a model.")
      .def_static(
          "read", [](const std::string& file) { return interruptible([&] { return StudyHandle::read(file); }); },
          py::arg("file"))
      .def_static(
          "of",
          [](const Given<ModelHandle>& model, const std::string& text, const std::string& folder) {
            return interruptible([&] { return StudyHandle::of(*model, text, folder); });
          },
          py::arg("model"), py::arg("text"), py::arg("folder"))
      .def_property_readonly("count", [](const GivenStudy& study) { return study->cases().count(); })
      .def(
          "run",
          [](const GivenStudy& study, const std::string& folder, int threads, bool retry_failed, double checkpoint,
             const py::object& progress) {
            return run_to_end(study, folder,
                              {checked_threads(threads), retry_failed, checked_number(checkpoint, "checkpoint", 0.0)},
                              progress);
          },
          py::arg("folder"), py::kw_only(), py::arg("threads") = 0, py::arg("retry_failed") = false,
          py::arg("checkpoint") = 60.0, py::arg("progress") = py::none(),
          "Runs the open cases. Returns True if it was interrupted.")
      .def("run_case", &run_one, py::arg("folder"), py::arg("number"),
           "Runs a single case with all its files. Returns its folder within that of the study.");
  py::class_<StudyResults, std::shared_ptr<StudyResults>>(module, "StudyTables", "Results of a study.")
      .def(py::init(&read_so_far), py::arg("folder"))
      .def("tree", &make_study_tree)
      .def("content", [](const Given<StudyResults>& results) { return to_python(study_tables_json(*results)); });
}

}  // namespace overbend
