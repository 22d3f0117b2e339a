/// What Python holds of an operation: its stages with the model that they are of.
#pragma once

#include <memory>

#include "python/model_handle.h"
#include "results/operation_results.h"

namespace overbend {

struct OperationHandle {
  std::shared_ptr<ModelHandle> model;
  OperationResults results;
};

}  // namespace overbend
