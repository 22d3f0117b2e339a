/// Governing stage of an operation.
#pragma once

#include "results/operation_results.h"

namespace overbend {

/// Returns the stage whose governing checks have the maximum utilisation; null if none was judged.
inline const StageResult* find_governing_stage(const OperationResults& results) {
  const StageResult* worst = nullptr;
  double max_utilisation = 0.0;
  for (const StageResult& stage : results.stages) {
    const CheckRow* row = stage.lay ? find_governing_check(stage.lay->checks) : nullptr;
    if (row == nullptr || (worst != nullptr && row->utilisation <= max_utilisation)) continue;
    worst = &stage;
    max_utilisation = row->utilisation;
  }
  return worst;
}

}  // namespace overbend
