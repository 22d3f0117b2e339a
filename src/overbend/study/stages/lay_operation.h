/// Statics of all stages of a lay operation, each starting from the previous one.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "model/description/description.h"
#include "results/operation_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Solves the stages one after the other, each from the solution of the last. A stage without an equilibrium holds its
/// failure; the others are still solved. `on_stage`, if given, is called after every stage; false ends the analysis.
OperationResults solve_operation(const Description& description,
                                 const std::function<bool(const StageResult&, std::size_t of)>& on_stage = {});

/// Writes the files of an operation and its report, completely or not at all. Throws UnusableFolder
/// (runstore/staged_folder.h) if the folder cannot be used.
void write_operation_run(const OperationResults& results, const Description& description,
                         const std::filesystem::path& folder);

/// Returns an error if stages of the operation cannot be solved for any values, although the model file is valid.
std::optional<StaticFailure> unsupported_in_operation(const Description& description);

}  // namespace overbend
