/// Statics of a hull that is pulled ahead on its winches, place by place.
#pragma once

#include <functional>
#include <variant>

#include "model/model.h"
#include "moorings/move_path.h"
#include "results/mooring_results.h"
#include "statics/moored/moored_rest.h"

namespace overbend {

/// The pipe at rest on a hull that lies there.
struct PipeThere {
  Vec6 load = Vec6::Zero();  ///< On the hull, about midship, axes of the hull as drawn [N, N m].
  PipeAtStep results;
};
/// A pipe whose hull moves.
struct PipeOnHull {
  Vec6 load = Vec6::Zero();  ///< As PipeThere::load, where the hull lies first: a part of its steady load.
  std::function<std::variant<PipeThere, StaticFailure>(const HullPlace& place)> at;  ///< Empty: there is no pipe.
};

/// How far the ends of a hull of a length move from one place to the other [m].
double way_between(const HullPlace& a, const HullPlace& b, double length);

/// A hull on its way: its lines have the lengths of where it was taken last.
class HullOnItsWay {
 public:
  /// `start`: at rest where the way begins.
  HullOnItsWay(const Model& model, const MooredHull& start, PipeOnHull pipe);

  /// Takes the hull ahead along the lay route [m]: lengths that hold it there against the pipe's pull at
  /// that place, with the least change of the pulls that the lines had at the beginning. The place that dynamic
  /// positioning wants moves as far; without lines the hull comes to rest about it. The same way gives the same
  /// lengths, wherever the hull comes from.
  std::optional<StaticFailure> go_to(double way);

  const MooredHull& hull() const { return hull_; }
  const MoveStep& step() const { return step_; }

 private:
  std::optional<StaticFailure> rest_with_pipe(const HullOffset& there);

  const Model* model_;
  PipeOnHull pipe_;
  MooredHull hull_;
  HullOffset from_;
  Vec3 wanted_ = Vec3::Zero();  ///< By dynamic positioning, at the beginning.
  Vec6 other_;                  ///< Steady load besides the pipe.
  Eigen::VectorXd wished_;
  MoveStep step_;
};

/// What winches do in time, from the places of the static analysis; `surge_period` as for move_profile.
WinchPlan winch_plan(const OperationDescription& operation, const std::vector<MoveStep>& steps, double surge_period);

}  // namespace overbend
