/// Statics of a hull that is pulled ahead on its winches, position by position.
#pragma once

#include <functional>
#include <variant>

#include "model/model.h"
#include "moorings/move_path.h"
#include "results/mooring_results.h"
#include "statics/moored/moored_equilibrium.h"

namespace overbend {

/// Pipe in equilibrium at a hull position.
struct PipeAtPosition {
  Vec6 load = Vec6::Zero();  ///< Load on the hull about midship, nominal axes of the hull [N, N m].
  PipeAtStep results;
};
/// Pipe on a moving hull.
struct PipeOnHull {
  Vec6 load = Vec6::Zero();  ///< As PipeAtPosition::load, at the initial position of the hull: part of its steady load.
  /// Solves the pipe at a position; empty if there is no pipe.
  std::function<std::variant<PipeAtPosition, StaticFailure>(const HullPlace& place)> solve_at;
};

/// Maximum displacement of the ends of a hull of a given length between two poses, estimated [m].
double end_displacement(const HullPlace& a, const HullPlace& b, double length);

/// Hull during a pull-ahead; its lines have the lengths of the last position.
class PullAheadPath {
 public:
  /// `start`: in equilibrium at the start of the pull-ahead.
  PullAheadPath(const Model& model, const MooredHull& start, PipeOnHull pipe);

  /// Moves the hull by `distance` ahead along the lay route from the start [m]: finds the lengths that hold it there
  /// against the pipe load, with the smallest change from the initial line forces. The target of dynamic positioning
  /// moves equally; without lines the hull settles near it. The result does not depend on the previous position.
  std::optional<StaticFailure> advance_to(double distance);

  const MooredHull& hull() const { return hull_; }
  const MoveStep& step() const { return step_; }

 private:
  std::optional<StaticFailure> solve_with_pipe(const HullOffset& start);

  const Model* model_;
  PipeOnHull pipe_;
  MooredHull hull_;
  HullOffset from_;
  Vec3 wanted_ = Vec3::Zero();  ///< Initial target of dynamic positioning.
  Vec6 load_without_pipe_;      ///< Steady load without the pipe.
  Eigen::VectorXd wanted_pulls_;
  MoveStep step_;
};

/// Winch lengths over time from the positions of the static analysis; `surge_period` as for move_profile [s].
WinchPlan winch_plan(const OperationDescription& operation, const std::vector<MoveStep>& steps, double surge_period);

}  // namespace overbend
