// Dynamic analyses written to folders: one run, several seeds, a comparison.
#include <pybind11/stl.h>

#include <chrono>

#include "base/units.h"
#include "dynamics/run/controllers.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "python/background_work.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/given_controller.h"
#include "python/python_errors.h"
#include "python/run_observer.h"
#include "python/statics_handle.h"
#include "runstore/run_store.h"
#include "study/run/case.h"
#include "study/run/prepared_case.h"
#include "study/seeds/study.h"

namespace overbend {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

/// Request for a run.
struct RunRequest {
  std::string stage;  ///< Stage of an operation; empty: the normal lay.
  std::optional<double> duration;
  std::vector<std::uint64_t> seeds;  ///< Empty: one run with the first seed of the model.
  bool several = false;              ///< Use a folder per seed, even for a single seed.
  std::string of;                    ///< Name of a ComparisonType, for a comparison.
  bool resume = false, restart = false;
  double checkpoint_every = 30.0;
  int threads = 0;
  GivenControllers controllers;  ///< Controllers of a single run.
};

StudyPlan taken(std::variant<StudyPlan, std::string> plan) {
  if (const auto* error = std::get_if<std::string>(&plan)) throw std::invalid_argument(*error);
  return std::get<StudyPlan>(std::move(plan));
}

StudyPlan make_plan(const Description& description, const RunRequest& request) {
  if (const auto comparison = from_enum_name<ComparisonType>(request.of)) {
    return taken(plan_comparison(*comparison, description, request.duration));
  }
  if (request.several) return taken(plan_seeds(request.seeds, request.duration));
  StudyPlan plan = plan_single(request.duration);
  if (!request.seeds.empty()) plan.cases.front().seed = request.seeds.front();
  plan.cases.front().controllers = controller_uses(request.controllers);
  return plan;
}

/// Throws if a folder holds an unfinished run and the request neither resumes nor restarts it.
void require_resume_choice(const std::vector<fs::path>& folders, const RunRequest& request) {
  if (request.resume || request.restart) return;
  for (const fs::path& folder : folders) {
    const std::optional<StoredRun> run = RunStore::find(folder);
    if (!run) continue;
    throw EndedRun({RunStatus::error, run->active
                                          ? "a run is active in '" + folder.string() + "'"
                                          : "there is an unfinished run in '" + folder.string() +
                                                "'; use resume=True to continue it or restart=True to start again"});
  }
}

StudyOutcome run_in(const Description& description, const RunRequest& request, const fs::path& folder,
                    RunObserver& watch) {
  const StudyPlan plan = make_plan(description, request);
  require_resume_choice(case_folders(plan, folder), request);
  return run_study(description, plan, folder, {request.resume, request.checkpoint_every, request.threads}, watch,
                   hdf5_lock());
}

/// Returns the status with the reasons of the failed runs.
RunResult make_run_end(const StudyOutcome& end) {
  std::string why = end.why;
  for (const FailedCase& failed_case : end.failed) {
    why += (why.empty() ? "" : "; ") + failed_case.name + ": " + failed_case.why;
  }
  return {end.ending, why};
}

py::dict status_dict(const StudyOutcome& end) {
  py::list failed;
  for (const FailedCase& failed_case : end.failed) failed.append(py::make_tuple(failed_case.name, failed_case.why));
  py::dict entries;
  entries["interrupted"] = end.ending == RunStatus::interrupted;
  entries["why"] = end.why;
  entries["failed"] = failed;
  return entries;
}

/// Runs until the end or until Python is interrupted; then the folder has a checkpoint.
py::dict run(const ModelHandle& model, const std::string& folder, const RunRequest& request,
             const py::object& progress) {
  RunObserver watch;
  StudyOutcome end;
  try {
    const auto work = [&] { end = run_in(chosen_description(model, request.stage), request, folder, watch); };
    run_in_background([&] { run_with_gil_calls(work); }, watch.stopped, [&] { watch.report_progress(progress); });
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_KeyboardInterrupt)) throw;
    py::dict entries = status_dict(end);
    entries["interrupted"] = true;
    return entries;
  }
  if (end.ending == RunStatus::wrong_input && end.why.starts_with(kControllerMessagePrefix)) {
    raise_controller_exception(request.controllers, end.why);
    raise_controller_error(end.why, "", "");
  }
  const bool some = end.seeds && !end.seeds->runs.empty();  // some seeds succeeded, others failed
  if (end.ending != RunStatus::done && end.ending != RunStatus::interrupted && !some) throw EndedRun(make_run_end(end));
  return status_dict(end);
}

double quantity(const std::string& text, const std::string& unit) {
  const QuantityReading reading = parse_quantity(text, unit);
  if (reading.value) return *reading.value;
  throw std::invalid_argument("found " + reading.found + ", expected " + dimension_phrase(unit) +
                              (reading.hint.empty() ? "" : "; " + reading.hint));
}

}  // namespace

void add_dynamics(py::module_& module) {
  module.def(
      "run",
      [](const Given<ModelHandle>& model, const std::string& folder, const std::string& stage,
         std::optional<double> duration, const std::vector<std::uint64_t>& seeds, bool several, const std::string& of,
         bool resume, bool restart, double checkpoint, int threads, const GivenControllers& controllers,
         const py::object& progress) {
        require_seeds(seeds);
        const RunRequest request{stage,
                                 duration,
                                 seeds,
                                 several,
                                 of,
                                 resume,
                                 restart,
                                 checked_number(checkpoint, "checkpoint", 0.0),
                                 checked_threads(threads),
                                 controllers};
        return run(*model, folder, request, progress);
      },
      py::arg("model"), py::arg("folder"), py::kw_only(), py::arg("stage") = "", py::arg("duration") = py::none(),
      py::arg("seeds") = std::vector<std::uint64_t>(), py::arg("several") = false, py::arg("of") = "",
      py::arg("resume") = false, py::arg("restart") = false, py::arg("checkpoint") = 30.0, py::arg("threads") = 0,
      py::arg("controllers") = GivenControllers(), py::arg("progress") = py::none(),
      "Runs into the folder. Returns {interrupted, why, failed}.");
  module.def("quantity", &quantity, py::arg("text"), py::arg("unit"),
             "Value of a text such as '600 s' in the SI unit.");
}

}  // namespace overbend
