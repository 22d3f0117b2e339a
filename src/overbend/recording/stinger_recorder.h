/// Recording of hinged stinger sections.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"
#include "numerics/running_statistics.h"
#include "results/stinger_dynamics.h"
#include "system/assembly.h"

namespace overbend {

/// Returns the names of the sections that move during the run; empty if no section is free to turn.
std::vector<std::string> moving_sections(const Model& model);

/// Force of a hinge on its section in the directions of the barge: horizontally astern, and upwards [N].
struct HingeForce {
  double longitudinal = 0.0, vertical = 0.0;
};
HingeForce hinge_force(const HingeReading& reading, const Vec3& astern_W);

/// Counts from t = 0 on.
class StingerRecorder {
 public:
  explicit StingerRecorder(const Model& model);

  /// Sets the state at the start of the run.
  void start(const Assembly& assembly);
  /// Adds an accepted step of `step` [s] that led to `time` [s]. Allocates nothing.
  void add(const Assembly& assembly, double time, double step);
  std::vector<StingerSectionDynamics> results() const;
  /// Warns of sections that hit a stop.
  Findings findings() const;
  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  enum Quantity : std::size_t { kAngle, kLongitudinal, kVertical, kForce, kStop, kDraught, kQuantities };
  struct RecordedSection {
    std::string name;
    double start = 0.0, fastest = 0.0, at_stop = 0.0, hits = 0.0, hardest = 0.0, hardest_at = 0.0;
    double stopped = 0.0;  ///< 1 while the section is at a stop.
  };

  std::vector<RecordedSection> sections_;
  Vec3 astern_W_;
  std::vector<double> sample_;
  RunningStatistics statistics_;
};

}  // namespace overbend
