/// The stage of an operation that decides.
#pragma once

#include "results/operation_results.h"

namespace overbend {

/// The stage whose governing checks are used most; null where none was judged.
inline const StageResult* worst_stage(const OperationResults& results) {
  const StageResult* worst = nullptr;
  double largest = 0.0;
  for (const StageResult& stage : results.stages) {
    const CheckRow* row = stage.lay ? worst_check(stage.lay->checks) : nullptr;
    if (row == nullptr || (worst != nullptr && row->utilisation <= largest)) continue;
    worst = &stage;
    largest = row->utilisation;
  }
  return worst;
}

}  // namespace overbend
