/// Early termination of a dynamic analysis once its code checks are decided.
#pragma once

#include "model/model.h"
#include "recording/run_dynamics.h"
#include "results/check_results.h"
#include "results/static_results.h"

namespace overbend {

/// True if a check judges the maximum over a run, so that it stays exceeded once it is. False for fatigue: damage is a
/// rate extrapolated over the passage of a weld and may decrease again in calmer waves.
bool is_irreversible(const CheckRow& row);

/// Keeps of a run that was ended early only the checks whose exceedance the rest of the run cannot undo.
void keep_irreversible_checks(CheckTable& table);

/// Evaluates the code checks of a run while it proceeds; a limit search can stop once a governing check is exceeded for
/// good. Serves one run; model and statics must outlive it.
class EarlyTermination {
 public:
  /// Checks at intervals of `every` of simulated time [s].
  EarlyTermination(const Model& model, const StaticResults& statics, double every = 5.0)
      : model_(&model), statics_(&statics), every_(every) {}

  /// True if such a check is exceeded at this instant; false before t = 0 and between evaluations.
  bool operator()(const DynamicProgress& progress);

 private:
  const Model* model_;
  const StaticResults* statics_;
  double every_, next_ = 0.0;
};

}  // namespace overbend
