/// A lift, all its stages: lines hauled and paid out, the vessel moved, ends welded.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "results/operation_results.h"
#include "statics/solver/linked_lines.h"
#include "statics/solver/statics.h"

namespace overbend {

/// The lines of a lift on their way from stage to stage. A copy goes on from there by itself, in a thread of its own
/// where that is wanted.
class Lift {
 public:
  explicit Lift(const Description& description);

  /// Brings the lines to the next of `stages`, whose first ones they have passed. A stage that cannot be reached says
  /// why, and the lines stay where they are.
  StageResult next(const std::vector<LayStageDescription>& stages);

 private:
  std::shared_ptr<const Model> model_;
  LinkedLines lines_;
  LiftPosition last_;  ///< What the lines were brought to: that of the last stage that stands.
  std::size_t passed_ = 0;
};

/// Brings the lines from stage to stage, as solve_operation() does it of a lay. A stage that cannot be reached says
/// why; those after it go on from the last that stands.
OperationResults solve_lift(const Description& description,
                            const std::function<bool(const StageResult&, std::size_t of)>& told);

/// The first stage with a line that cannot reach, as a fault of the file; none where all can.
std::optional<StaticFailure> lift_obstacle(const Description& description);

}  // namespace overbend
