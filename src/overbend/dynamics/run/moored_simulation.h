/// A hull on its mooring lines in time, without a pipe: a run of lines (system_run.h) from where they rest together.
///
///     MooredSimulation moored(model, start, options);
///     if (!moored.failure()) { moored.run().observe(...); while (moored.run().step()) ... }
#pragma once

#include "dynamics/run/system_run.h"
#include "dynamics/setup/run_setup.h"

namespace overbend {

class MooredSimulation {
 public:
  /// At rest at the beginning of the build-up. `start`: of solve_moored_hull(), by which `model` has its mean pose; the
  /// model must outlive this. Throws std::invalid_argument for a sea or a motion that cannot be made.
  MooredSimulation(const Model& model, const StaticSolution& start, const DynamicOptions& options);
  MooredSimulation(const MooredSimulation&) = delete;
  MooredSimulation& operator=(const MooredSimulation&) = delete;

  /// Why there is no run, or why it cannot go on.
  const std::optional<StaticFailure>& failure() const { return run_ ? run_->failure() : failure_; }
  SystemRun& run() { return *run_; }
  const SystemRun& run() const { return *run_; }
  /// Names of the lines, in the order of the system.
  const std::vector<std::string>& moorings() const { return setup_.mooring_names; }
  /// The way on which the vessel is moved ahead; null where it is not.
  const MoveProfile* move() const { return setup_.move ? &*setup_.move : nullptr; }
  /// The vessel that floats free; null where its motion is told.
  const Hull* hull() const { return setup_.hull ? &setup_.hull->hull : nullptr; }
  /// Of the water over the mean place of midship [m].
  double elevation() const;

 private:
  std::optional<StaticFailure> rest(SystemState& state);

  RunSetup setup_;
  DynamicOptions options_;
  Vec3 midship_;  ///< Its place before any move, W [m].
  Vec3 ahead_W_;  ///< Horizontal unit vector ahead along the lay route.
  std::optional<StaticFailure> failure_;
  std::optional<SystemRun> run_;
};

}  // namespace overbend
