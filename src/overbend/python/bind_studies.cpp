// Studies of many cases into folders.
#include <algorithm>

#include "python/bindings.h"
#include "python/given.h"
#include "python/python_errors.h"
#include "python/study_handle.h"
#include "python/to_python.h"
#include "python/without_lock.h"
#include "resultfiles/hdf5/result_tree.h"
#include "resultfiles/studies/operability_json.h"
#include "resultfiles/studies/study_writer.h"
#include "runstore/staged_folder.h"
#include "study/campaign/whole_study.h"

namespace overbend {
namespace {

namespace py = pybind11;

struct StudyConduct {
  int threads = 0;
  bool retry_failed = false;
  double checkpoint_every = 60.0;
};

using GivenStudy = Given<StudyHandle>;

/// Whether it was interrupted before its end.
bool run_to_end(const GivenStudy& study, const std::string& folder, const StudyConduct& conduct,
                const py::object& progress) {
  CaseCount count;
  bool interrupted = false;
  const auto work = [&] {
    study->open(folder);
    StudyRunOptions options{.threads = conduct.threads, .retry_failed = conduct.retry_failed};
    options.checkpoint_every = conduct.checkpoint_every;
    const WholeStudy whole = run_whole_study(study->base(), folder, options, count);
    interrupted = whole.ending == RunEnding::interrupted;
    if (whole.ending != RunEnding::done && !interrupted) throw UnusableFolder(whole.why);
  };
  const auto tell = [&] {
    const CaseCount::Told told = count.told();
    if (!progress.is_none() && told.done > 0) progress(told.done, told.cases, told.failed);
  };
  try {
    work_beside(work, count.stopped, tell);
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_KeyboardInterrupt)) throw;
    interrupted = true;
  }
  return interrupted;
}

/// One case alone, with all its files: its folder within that of the study.
std::string run_one(const GivenStudy& study, const std::string& folder, std::size_t number) {
  checked_index(number, study->cases().count(), "cases");
  StudyCase one;
  std::atomic<bool> stop = false;
  const auto work = [&] {
    study->open(folder);
    one = run_study_case(study->base(), study->cases(), folder, number, [&] { return stop.load(); });
  };
  work_beside(work, stop, {});
  if (one.state == StudyCaseState::failed) throw EndedRun({RunEnding::no_solution, one.reason});
  return one.folder;
}

std::shared_ptr<StudyResults> read_so_far(const std::string& folder) {
  return reading_results([&] { return std::make_shared<StudyResults>(study_so_far(folder)); });
}

std::shared_ptr<ResultTree> tree_of_study(const Given<StudyResults>& results) {
  auto tree = std::make_shared<ResultTree>();
  write_study_groups(*tree, *results);
  return tree;
}

/// What the columns of the table are, and the limits that were looked for.
Json told_study(const StudyResults& results) {
  Json inputs = Json::array(), outputs = Json::array();
  for (const StudyInput& one : results.inputs) {
    inputs.push_back({{"key", one.key},
                      {"unit", one.unit},
                      {"with", one.with},
                      {"sampled", one.sampled},
                      {"words", one.words},
                      {"values", one.values}});
  }
  for (const StudyOutput& one : results.outputs) {
    outputs.push_back({{"name", one.name}, {"unit", one.unit}, {"text", one.text}});
  }
  const auto seeds = std::ranges::count_if(results.cases, [](const StudyCase& one) { return one.group == 0; });
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
          "Runs what is open; whether it was interrupted.")
      .def("run_case", &run_one, py::arg("folder"), py::arg("number"),
           "Solves one case with all its files: its folder within that of the study.");
  py::class_<StudyResults, std::shared_ptr<StudyResults>>(module, "StudyTables", "What a study gave.")
      .def(py::init(&read_so_far), py::arg("folder"))
      .def("tree", &tree_of_study)
      .def("told", [](const Given<StudyResults>& results) { return to_python(told_study(*results)); });
}

}  // namespace overbend
