/// An operation on the line, all its stages: statics of each, from that before.
#pragma once

#include <functional>

#include "model/description.h"
#include "results/operation_results.h"

namespace overbend {

/// Solves the stages one after the other, each from the solution of the last. A stage without an equilibrium says why
/// and leaves the others standing. `told`, where given, hears of every stage that is done; false from it ends the rest.
OperationResults solve_operation(const Description& description,
                                 const std::function<bool(const StageResult&, std::size_t of)>& told = {});

}  // namespace overbend
