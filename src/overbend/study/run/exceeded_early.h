/// Ends a dynamic analysis as soon as its verdict is known.
#pragma once

#include "model/model.h"
#include "recording/run_dynamics.h"
#include "results/check_results.h"
#include "results/static_results.h"

namespace overbend {

/// Whether a check judges the largest value of a run, so that it stays exceeded once it is. Fatigue does not: it is
/// damage by the hour of the cycles so far, extrapolated to the way of a weld, and falls again in calmer waves.
bool stays_exceeded(const CheckRow& row);

/// Leaves of the checks of a run that was ended early those that the rest of the run would not take back.
void keep_lasting_checks(CheckTable& table);

/// Looks at the code checks of a run while it goes on: once a governing one is exceeded that stays so, a search for
/// limits needs no more. Of one run; model and statics have to outlive it.
class ExceededEarly {
 public:
  /// Looks every `every` of simulated time [s].
  ExceededEarly(const Model& model, const StaticResults& statics, double every = 5.0)
      : model_(&model), statics_(&statics), every_(every) {}

  /// Whether such a check is exceeded at this instant; false before t = 0 and between the looks.
  bool operator()(const DynamicProgress& at);

 private:
  const Model* model_;
  const StaticResults* statics_;
  double every_, next_ = 0.0;
};

}  // namespace overbend
