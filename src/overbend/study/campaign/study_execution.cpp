#include "study/campaign/study_execution.h"

#include <mutex>

#include "base/interruption.h"
#include "runstore/staged_folder.h"
#include "study/operability/operability_folder.h"

namespace overbend {
namespace {

bool find_limits(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                 StudyObserver& watch) {
  OperabilityOptions conduct{folder, options.threads, options.checkpoint_every, options.task, options.tasks};
  conduct.stop = [&] { return watch.stop(); };
  conduct.abandon = [&] { return watch.abandon(); };
  conduct.on_advance = [&] { watch.advanced(); };
  conduct.on_trial = [&](const TrialReport& trial) {
    if (!trial.known && trial.result.end != TrialStatus::open) watch.tried(trial);
  };
  write_operability(run_operability(base, conduct), folder);
  return !watch.stop();
}

/// Runs the cases and writes the tables; returns true if completed.
bool run_and_gather(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder,
                    const StudyRunOptions& options, StudyObserver& watch, StudyExecution& whole) {
  const InterruptionScope scope([&] { return watch.abandon(); });
  if (base.study().operability) {
    if (!find_limits(base, folder, options, watch)) return false;
  } else {
    whole.tally = run_study_cases(base, cases, folder, options, watch);
    if (whole.tally.interrupted) return false;
  }
  if (!options.tables) return true;
  const std::lock_guard hold(hdf5_lock());
  whole.results = gather_study(folder);
  return true;
}

}  // namespace

StudyExecution execute_study(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                             StudyObserver& watch) {
  StudyExecution results;
  const StudyCases cases(base.study());
  try {
    open_study(base, cases, folder);
  } catch (const UnusableFolder& error) {
    static_cast<RunResult&>(results) = {RunStatus::wrong_input, error.what()};
    return results;
  }
  bool finished = false;
  try {
    finished = run_and_gather(base, cases, folder, options, watch, results);
  } catch (const Interrupted&) {  // between the cases
  }
  if (!finished) static_cast<RunResult&>(results) = {RunStatus::interrupted, "interrupted"};
  return results;
}

}  // namespace overbend
