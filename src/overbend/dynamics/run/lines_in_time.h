/// Lines by themselves in motion: ends that swing as told or move with the vessel, waves and current on every line.
#pragma once

#include "dynamics/run/system_run.h"
#include "mechanics/vessel_motion.h"
#include "numerics/running_statistics.h"
#include "statics/solver/lines_setup.h"

namespace overbend {

/// Sets bodies and ends of a system of `lines_setup`: the vessel moves as the model says, an end that is not on it
/// about its place by its harmonic motion; both are brought in with the sea over `build_up` seconds before t = 0.
LeadEnds moving_ends(const Model& model, VesselMotionModel vessel, double build_up);

/// The lines at rest as a state of motion: accelerations zero, the bed's friction stretched as it holds them.
SystemState resting_lines(const System& system, const SystemState& at_rest, const LinesRest& rest, double time);

/// Histories of a run: tension at both ends of every line and how it moves.
struct LineHistory {
  std::vector<double> time;         ///< [s]
  std::vector<double> first, last;  ///< Tension at the ends, along the line, negative where they are pushed [N].
  double least_first = 1e300, most_first = -1e300, least_last = 1e300, most_last = -1e300;  ///< Over all steps [N].
  std::vector<double> least_tension, most_tension;  ///< At the nodes, over all steps [N].
  RunningStatistics ends{2};                        ///< Of `first` and `last`, every step by its length.
};

/// Keeps them from t = 0 on.
class LineRecorder : public SystemObserver {
 public:
  explicit LineRecorder(const System& system);
  const std::vector<LineHistory>& histories() const { return lines_; }
  void stepped(const SystemRun& run) override;
  void row(const SystemRun& run) override;
  void save(DynamicCheckpoint& checkpoint) const override;
  void restore(const DynamicCheckpoint& checkpoint) override;

 private:
  std::vector<LineHistory> lines_;
};

}  // namespace overbend
