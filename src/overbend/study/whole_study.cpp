#include "study/whole_study.h"

#include <mutex>

#include "runstore/staged_folder.h"
#include "study/operability_folder.h"

namespace overbend {
namespace {

bool find_limits(const CaseBase& base, const std::filesystem::path& folder, const StudyRunOptions& options,
                 StudyWatch& watch) {
  OperabilityConduct conduct{folder, options.threads, options.checkpoint_every, options.task, options.tasks};
  conduct.files = options.files;
  conduct.stop = [&] { return watch.stop(); };
  conduct.told = [&](const TrialTold& trial) {
    if (!trial.known && trial.result.end != TrialEnd::open) watch.tried(trial);
  };
  write_operability(run_operability(base, conduct), folder);
  return !watch.stop();
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
  if (base.study().operability) {
    finished = find_limits(base, folder, options, watch);
  } else {
    whole.tally = run_study_cases(base, cases, folder, options, watch);
    finished = !whole.tally.interrupted;
  }
  if (!finished) {
    static_cast<RunEnd&>(whole) = {RunEnding::interrupted, "interrupted"};
  } else if (options.tables) {
    FileLock own;
    const std::lock_guard hold(options.files != nullptr ? *options.files : own);
    whole.results = gather_study(folder);
  }
  return whole;
}

}  // namespace overbend
