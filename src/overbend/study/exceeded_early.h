/// Ends a dynamic analysis as soon as its verdict is known.
#pragma once

#include "model/model.h"
#include "recording/run_dynamics.h"
#include "results/static_results.h"

namespace overbend {

/// Looks at the code checks of a run while it goes on. They judge the largest values of the run: a check that is
/// exceeded once stays so, and a search for limits needs no more. Of one run; model and statics have to outlive it.
class ExceededEarly {
 public:
  /// Looks every `every` of simulated time [s].
  ExceededEarly(const Model& model, const StaticResults& statics, double every = 5.0)
      : model_(&model), statics_(&statics), every_(every) {}

  /// Whether a governing check is exceeded at this instant; false before t = 0 and between the looks.
  bool operator()(const DynamicProgress& at);

 private:
  const Model* model_;
  const StaticResults* statics_;
  double every_, next_ = 0.0;
};

}  // namespace overbend
