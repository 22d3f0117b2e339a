/// An operation on the line, all its stages: statics of each, from that before.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "model/description/description.h"
#include "results/operation_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Solves the stages one after the other, each from the solution of the last. A stage without an equilibrium says why
/// and leaves the others standing. `told`, where given, hears of every stage that is done; false from it ends the rest.
OperationResults solve_operation(const Description& description,
                                 const std::function<bool(const StageResult&, std::size_t of)>& told = {});

/// Writes the files of an operation and its report, whole or not at all. Throws UnusableFolder
/// (runstore/staged_folder.h) when the folder cannot be.
void write_operation_run(const OperationResults& results, const Description& description,
                         const std::filesystem::path& folder);

/// Why stages of the operation cannot be solved whatever their numbers, though the model can say it.
std::optional<StaticFailure> operation_obstacle(const Description& description);

}  // namespace overbend
