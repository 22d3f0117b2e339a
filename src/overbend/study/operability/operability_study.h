/// The search for limits of a study: every analysis in a folder of its own, with one record.
#pragma once

#include <functional>

#include "results/study_results.h"
#include "study/operability/operability_plan.h"

namespace overbend {

/// An analysis that has just ended.
struct TrialTold {
  std::size_t cell = 0, value = 0, seed = 0;
  TrialResult result;
  double wall_time = 0.0;  ///< [s]
  bool known = false;      ///< From its record: it was run before.
};

struct OperabilityConduct {
  std::filesystem::path folder;    ///< Of the study.
  int threads = 0;                 ///< 0: as many as there are cores.
  double checkpoint_every = 60.0;  ///< Of each analysis [s].
  std::size_t task = 0,
              tasks = 1;  ///< Runs chains task, task + tasks, ... (study/operability/operability_search.h) only.
  bool gather = false;    ///< Runs nothing: limits as far as the records tell.
  std::function<bool()> stop = {};                  ///< Whether to end, each analysis at a checkpoint.
  std::function<void(const TrialTold&)> told = {};  ///< Called from several threads.
};

/// Finds the limits. Analyses with a record of the same question are not run again, one that was interrupted goes on
/// from its checkpoint; so a search that was killed asks the same questions again and gives what it would have given.
/// A value at which the model is refused or finds no equilibrium counts as not passed, except the least, which stays
/// open then. Throws FileFault when the disk refuses a record.
OperabilityResults run_operability(const CaseBase& base, const OperabilityConduct& conduct);

/// How an answer compares with the criterion.
TrialResult judged_trial(const CaseAnswer& answer, const OperabilityDescription& wanted, bool least);

}  // namespace overbend
