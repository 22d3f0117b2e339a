// Dynamic analyses into folders: one run, several seeds, a comparison.
#include <pybind11/stl.h>

#include <chrono>

#include "base/units.h"
#include "dynamics/run/controllers.h"
#include "dynamics/setup/dynamic_obstacle.h"
#include "python/bindings.h"
#include "python/given.h"
#include "python/given_controller.h"
#include "python/python_errors.h"
#include "python/run_watch.h"
#include "python/statics_handle.h"
#include "python/without_lock.h"
#include "runstore/run_store.h"
#include "study/run/case.h"
#include "study/run/prepared_case.h"
#include "study/seeds/study.h"

namespace overbend {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

/// What is asked for.
struct RunWish {
  std::string stage;  ///< Of an operation on the line.
  std::optional<double> duration;
  std::vector<std::uint64_t> seeds;  ///< Empty: one run with the model's first seed.
  bool several = false;              ///< A folder for each seed, even of one.
  std::string of;                    ///< Of a comparison: a word of ComparisonOf.
  bool resume = false, restart = false;
  double checkpoint_every = 30.0;
  int threads = 0;
  GivenControllers controllers;  ///< Of one run.
};

StudyPlan taken(std::variant<StudyPlan, std::string> plan) {
  if (const auto* fault = std::get_if<std::string>(&plan)) throw std::invalid_argument(*fault);
  return std::get<StudyPlan>(std::move(plan));
}

StudyPlan plan_of(const Description& description, const RunWish& wish) {
  if (const auto of = from_word<ComparisonOf>(wish.of)) return taken(plan_comparison(*of, description, wish.duration));
  if (wish.several) return taken(plan_seeds(wish.seeds, wish.duration));
  StudyPlan plan = plan_single(wish.duration);
  if (!wish.seeds.empty()) plan.cases.front().seed = wish.seeds.front();
  plan.cases.front().controllers = uses_of(wish.controllers);
  return plan;
}

/// What was begun and not finished in a folder is neither lost nor gone on with unasked.
void require_wish(const std::vector<fs::path>& folders, const RunWish& wish) {
  if (wish.resume || wish.restart) return;
  for (const fs::path& folder : folders) {
    const std::optional<StoredRun> run = RunStore::find(folder);
    if (!run) continue;
    throw EndedRun({RunEnding::fault, run->active ? "a run is active in '" + folder.string() + "'"
                                                  : "there is an unfinished run in '" + folder.string() +
                                                        "'; resume=True goes on with it, restart=True begins anew"});
  }
}

StudyEnd run_in(const Description& description, const RunWish& wish, const fs::path& folder, RunWatch& watch) {
  const StudyPlan plan = plan_of(description, wish);
  require_wish(case_folders(plan, folder), wish);
  return run_study(description, plan, folder, {wish.resume, wish.checkpoint_every, wish.threads}, watch, hdf5_lock());
}

/// How it ended, with the reasons of the runs that failed.
RunEnd all_told(const StudyEnd& end) {
  std::string why = end.why;
  for (const FailedCase& one : end.failed) why += (why.empty() ? "" : "; ") + one.name + ": " + one.why;
  return {end.ending, why};
}

py::dict told_end(const StudyEnd& end) {
  py::list failed;
  for (const FailedCase& one : end.failed) failed.append(py::make_tuple(one.name, one.why));
  py::dict told;
  told["interrupted"] = end.ending == RunEnding::interrupted;
  told["why"] = end.why;
  told["failed"] = failed;
  return told;
}

/// Runs until the end or until Python is interrupted; then a checkpoint is in the folder.
py::dict run(const ModelHandle& model, const std::string& folder, const RunWish& wish, const py::object& progress) {
  RunWatch watch;
  StudyEnd end;
  try {
    const auto work = [&] { end = run_in(chosen_description(model, wish.stage), wish, folder, watch); };
    work_beside([&] { work_with_calls(work); }, watch.stopped, [&] { watch.tell(progress); });
  } catch (py::error_already_set& error) {
    if (!error.matches(PyExc_KeyboardInterrupt)) throw;
    py::dict told = told_end(end);
    told["interrupted"] = true;
    return told;
  }
  if (end.ending == RunEnding::wrong_input && end.why.starts_with(kControllerOf)) {
    raise_of_controllers(wish.controllers, end.why);
    raise_controller_error(end.why, "", "");
  }
  const bool some = end.seeds && !end.seeds->runs.empty();  // and others failed
  if (end.ending != RunEnding::done && end.ending != RunEnding::interrupted && !some) throw EndedRun(all_told(end));
  return told_end(end);
}

double quantity(const std::string& text, const std::string& unit) {
  const QuantityReading reading = parse_quantity(text, unit);
  if (reading.value) return *reading.value;
  throw std::invalid_argument("found " + reading.found + ", expected " + dimension_words(unit) +
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
        const RunWish wish{stage,
                           duration,
                           seeds,
                           several,
                           of,
                           resume,
                           restart,
                           checked_number(checkpoint, "checkpoint", 0.0),
                           checked_threads(threads),
                           controllers};
        return run(*model, folder, wish, progress);
      },
      py::arg("model"), py::arg("folder"), py::kw_only(), py::arg("stage") = "", py::arg("duration") = py::none(),
      py::arg("seeds") = std::vector<std::uint64_t>(), py::arg("several") = false, py::arg("of") = "",
      py::arg("resume") = false, py::arg("restart") = false, py::arg("checkpoint") = 30.0, py::arg("threads") = 0,
      py::arg("controllers") = GivenControllers(), py::arg("progress") = py::none(),
      "Runs into the folder: {interrupted, why, failed}.");
  module.def("quantity", &quantity, py::arg("text"), py::arg("unit"), "A text such as '600 s' in the SI unit.");
}

}  // namespace overbend
