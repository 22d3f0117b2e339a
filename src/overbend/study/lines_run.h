/// Analyses of a model that is nothing but lines between two ends.
#pragma once

#include <filesystem>
#include <optional>

#include "dynamics/dynamics.h"
#include "results/line_results.h"

namespace overbend {

struct LinesOutcome {
  std::optional<LinesResults> results;
  std::optional<StaticFailure> failure;
};

/// Whether a model is lines by themselves and nothing else.
bool is_lines_alone(const Description& description);

/// The lines at rest.
LinesOutcome solve_lines(const Model& model);

/// The same and a run in time from there. Throws std::invalid_argument for a sea or a motion that cannot be made.
LinesOutcome run_lines(const Model& model, const DynamicOptions& options);

/// Writes all files to `folder`, whole or not at all. Throws UnusableFolder.
void write_lines_run(const LinesResults& results, const Description& description, const std::filesystem::path& folder);

}  // namespace overbend
