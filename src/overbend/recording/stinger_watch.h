/// What a stinger on hinges did over a run.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/model.h"
#include "numerics/running_statistics.h"
#include "results/stinger_dynamics.h"
#include "system/assembly.h"

namespace overbend {

/// Names of the sections that move in time; none where no section turns by itself.
std::vector<std::string> sections_in_time(const Model& model);

/// Force of a hinge on its section, along the barge as it lies: level astern, and up [N].
struct HingeForce {
  double longitudinal = 0.0, vertical = 0.0;
};
HingeForce hinge_force(const HingeReading& reading, const Vec3& astern_W);

/// Counts from t = 0 on.
class StingerWatch {
 public:
  explicit StingerWatch(const Model& model);

  /// The state at the start of the run.
  void start(const Assembly& assembly);
  /// An accepted step of `step` [s] that led to `time`. Nothing is allocated.
  void add(const Assembly& assembly, double time, double step);
  std::vector<StingerSectionDynamics> results() const;
  /// Sections that ran into a stop or turned far.
  Findings findings() const;
  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  enum Quantity : std::size_t { kAngle, kLongitudinal, kVertical, kForce, kStop, kDraught, kQuantities };
  struct Watched {
    std::string name;
    double start = 0.0, fastest = 0.0, at_stop = 0.0, hits = 0.0, hardest = 0.0, hardest_at = 0.0;
    double stopped = 0.0;  ///< 1 while it is at a stop.
  };

  std::vector<Watched> sections_;
  Vec3 astern_W_;
  std::vector<double> sample_;
  RunningStatistics statistics_;
};

}  // namespace overbend
