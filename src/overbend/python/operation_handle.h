/// An operation in Python: the results of its stages, with the model.
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
