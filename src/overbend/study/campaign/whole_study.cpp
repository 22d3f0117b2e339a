#include "study/campaign/whole_study.h"

#include <mutex>

#include "base/interruption.h"
#include "runstore/staged_folder.h"
#include "study/operability/operability_folder.h"

namespace overbend {
namespace {

bool find_limits(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                 StudyWatch& watch) {
  OperabilityConduct conduct{folder, options.threads, options.checkpoint_every, options.task, options.tasks};
  conduct.stop = [&] { return watch.stop(); };
  conduct.told = [&](const TrialTold& trial) {
    if (!trial.known && trial.result.end != TrialEnd::open) watch.tried(trial);
  };
  write_operability(run_operability(base, conduct), folder);
  return !watch.stop();
}

/// Cases and tables; whether it came to their end.
bool run_and_gather(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder,
                    const StudyRunOptions& options, StudyWatch& watch, WholeStudy& whole) {
  const InterruptionScope scope([&] { return watch.stop(); });
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

WholeStudy run_whole_study(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                           StudyWatch& watch) {
  WholeStudy whole;
  const StudyCases cases(base.study());
  try {
    open_study(base, cases, folder);
  } catch (const UnusableFolder& fault) {
    static_cast<RunEnd&>(whole) = {RunEnding::wrong_input, fault.what()};
    return whole;
  }
  bool finished = false;
  try {
    finished = run_and_gather(base, cases, folder, options, watch, whole);
  } catch (const Interrupted&) {  // between the cases
  }
  if (!finished) static_cast<RunEnd&>(whole) = {RunEnding::interrupted, "interrupted"};
  return whole;
}

}  // namespace overbend
