/// All stages of a lift: lines hauled in and paid out, the vessel moved, ends welded.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "results/operation_results.h"
#include "statics/solver/linked_lines.h"
#include "statics/solver/statics.h"

namespace overbend {

/// The lines of a lift from stage to stage. A copy continues independently, if wanted in another thread.
class Lift {
 public:
  explicit Lift(const Description& description);

  /// Brings the lines to the next of `stages`, of which the first ones are passed. A stage that cannot be reached holds
  /// its failure, and the lines stay where they are.
  StageResult next(const std::vector<LayStageDescription>& stages);

 private:
  std::shared_ptr<const Model> model_;
  LinkedLines lines_;
  LiftPosition last_;  ///< Target that the lines reached: that of the last solved stage.
  std::size_t passed_ = 0;
};

/// Solves all stages of a lift, as solve_operation() does for a lay. A stage that cannot be reached holds its failure;
/// later stages continue from the last solved one.
OperationResults solve_lift(const Description& description,
                            const std::function<bool(const StageResult&, std::size_t of)>& on_stage);

/// Returns the first stage with a line that cannot reach, as an input error; empty if all can.
std::optional<StaticFailure> find_unreachable_stage(const Description& description);

}  // namespace overbend
