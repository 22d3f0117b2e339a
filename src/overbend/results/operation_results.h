/// Results of an operation on the line, stage by stage. SI; frames as in static_results.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/description/lay_operation_description.h"
#include "model/description/mooring_description.h"
#include "results/static_results.h"

namespace overbend {

/// Reason why a stage is infeasible, and a remedy.
struct StageFailure {
  std::string what, where, why;
  std::optional<double> min_tension;  ///< Minimum feasible top tension [N].
};

struct StageResult {
  LayStageDescription stage;            ///< As computed: with its name, and with the tension if it was solved for.
  std::optional<StaticResults> lay;     ///< Equilibrium and code checks.
  std::optional<StageFailure> failure;  ///< Reason if there is no equilibrium.
  double barge_ahead = 0.0;             ///< Distance of the vessel ahead of its position in the first stage [m].
  std::string governing;                ///< Limit that determines a solved tension; empty for a given tension.
  Findings findings;                    ///< Findings of this stage in addition to those of `lay`.
};

struct OperationResults {
  std::string title, version;
  OperationType type = OperationType::abandonment;
  Assumptions assumptions;
  Findings findings;                ///< Findings of the operation as a whole.
  std::vector<StageResult> stages;  ///< In the order of the operation.
  double wall_time = 0.0;           ///< Total wall time [s].
};

}  // namespace overbend
