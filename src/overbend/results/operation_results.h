/// Results of an operation on the line, stage by stage. SI; frames as in static_results.h.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/description/lay_operation.h"
#include "model/description/mooring_description.h"
#include "results/static_results.h"

namespace overbend {

/// Why a stage cannot be, and what would let it be.
struct StageFailure {
  std::string what, where, why;
  std::optional<double> least_tension;  ///< At the top, with which it can be [N].
};

struct StageResult {
  LayStageDescription stage;            ///< As computed: named, with the tension found where it was sought.
  std::optional<StaticResults> lay;     ///< Equilibrium and code checks.
  std::optional<StageFailure> failure;  ///< Where there is none.
  double barge_ahead = 0.0;             ///< How far the barge lies ahead of the first stage's place [m].
  std::string governing;                ///< The limit that a sought tension is on; empty where none was sought.
  Findings findings;                    ///< Of this stage, besides those of `lay`.
};

struct OperationResults {
  std::string title, version;
  OperationType type = OperationType::abandonment;
  Assumptions assumptions;
  Findings findings;                ///< Of the operation as a whole.
  std::vector<StageResult> stages;  ///< In the order in which they are done.
  double wall_time = 0.0;           ///< Of all [s].
};

}  // namespace overbend
