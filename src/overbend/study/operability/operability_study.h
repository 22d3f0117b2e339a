/// The limit search of a study: every analysis in its own folder, with one record.
#pragma once

#include <functional>

#include "results/study_results.h"
#include "study/operability/operability_plan.h"

namespace overbend {

/// Report of a finished analysis.
struct TrialReport {
  std::size_t cell = 0, value = 0, seed = 0;
  TrialResult result;
  double wall_time = 0.0;  ///< [s]
  bool known = false;      ///< True if read from the record of an earlier run.
};

struct OperabilityOptions {
  std::filesystem::path folder;    ///< Folder of the study.
  int threads = 0;                 ///< 0: the number of cores.
  double checkpoint_every = 60.0;  ///< Checkpoint interval of each analysis [s].
  std::size_t task = 0,
              tasks = 1;  ///< Runs only the chains task, task + tasks, ... (study/operability/operability_search.h).
  bool gather = false;    ///< Runs nothing: limits from the present records.
  std::function<bool()> stop = {};                        ///< True to stop; each analysis stops at a checkpoint.
  std::function<bool()> abandon = {};                     ///< True to abandon statics as well. By default like `stop`.
  std::function<void(const TrialReport&)> on_trial = {};  ///< Called from several threads.
  std::function<void()> on_advance = {};                  ///< Called after every output step, from several threads.
};

/// Finds the limits. Analyses with a record of the same input are not repeated, and an interrupted one resumes from its
/// checkpoint; so a search that was killed repeats the same sequence and gives the same results. A value at which the
/// model is rejected or has no equilibrium counts as not passed, except the minimum, which then stays open. Throws
/// FileError if a record cannot be written.
OperabilityResults run_operability(const CaseBase& base, const OperabilityOptions& conduct);

/// Compares a result with the criterion. `is_minimum`: the value is the minimum of the grid.
TrialResult judged_trial(const CaseResult& answer, const OperabilityDescription& wanted, bool is_minimum);

}  // namespace overbend
