/// What a run in time leaves behind: statistics of every station and support, rows of histories, snapshots.
#pragma once

#include <span>
#include <vector>

#include "dynamics/dynamics.h"
#include "numerics/running_quantiles.h"
#include "numerics/running_statistics.h"
#include "recording/design_recorder.h"
#include "recording/dynamic_stations.h"
#include "recording/surface_crossing.h"
#include "recording/tensioner_account.h"
#include "system/find_regions.h"

namespace overbend {

/// The largest of a region: now, and of all times.
struct RegionPeak {
  double now = 0.0;
  double largest = -1.0, s = 0.0, time = 0.0;
};

/// Key figures at one instant.
struct KeyValues {
  double top_tension = 0.0, bottom_tension = 0.0, lay_back = 0.0, departure_angle = 0.0, tip_clearance = 0.0;
  /// Bending moment, bending stress, von Mises stress, strain. `upper`: of the overbend, or of the tower where no
  /// support carries in the static state.
  RegionPeak upper[4], sagbend[4];
  RegionPeak slack;  ///< Of the least effective tension along the line, with its sign turned.
};

inline constexpr double kNever = 1e300;

/// One instant as the recorder is told of it.
struct RecordedInstant {
  const SystemState* state = nullptr;
  const Assembly* system = nullptr;
  double step = 0.0;       ///< That led here [s].
  double elevation = 0.0;  ///< Of the water at the stern shoe's mean place [m].
  double drift = 0.0;      ///< Of energy, relative.

  const LineState& pipe() const { return state->lines.front(); }
  const std::vector<RollerContact>& contacts() const { return system->line(0).contacts().contacts(); }
  const RigidMotion& vessel() const { return system->surroundings().bodies.front(); }
  const std::vector<double>& water() const { return system->surroundings().water.front(); }
  const AttachmentState& tensioner() const {
    return state->attachments[static_cast<std::size_t>(system->system().machine)];
  }
};

class DynamicRecorder {
 public:
  DynamicRecorder(const Model& model, const System& system);

  std::vector<HistoryColumn> columns() const;
  /// Nodes of the static line: the laid tail behind it is not recorded.
  int stations() const { return line_->mesh.nodes() - static_cast<int>(first_); }

  /// Tells the checks what the current adds to the static state; before start().
  void tell_current(const StaticResults& statics);
  /// The static state, by the same recovery.
  void start(const RecordedInstant& at);
  /// Every accepted step; statistics count from t > 0.
  void step(const RecordedInstant& at);
  /// The row at this instant; forgets what was largest since the last.
  std::span<const double> row(const RecordedInstant& at);
  std::span<const double> snapshot(const RecordedInstant& at);
  double top_tension() const { return key_.top_tension; }
  /// Impacts that ended: counted, and what they do to pipe and coating filled in.
  void count(Impact& impact);

  /// Statistics into results; leaves what the recorder does not know.
  void fill(DynamicResults& results) const;

  void save(DynamicCheckpoint& checkpoint) const;
  void restore(const DynamicCheckpoint& checkpoint);

 private:
  void recover(const RecordedInstant& at);
  DesignInstant design_instant(const RecordedInstant& at) const;
  void forget_interval();
  void find_key_values(const RecordedInstant& at);
  void find_region_peaks(const Regions& regions, double time);
  void find_slack(double time);
  std::optional<double> departure(const RecordedInstant& at) const;
  void find_support_values(const RecordedInstant& at);
  void find_passed(const RecordedInstant& at);
  void fill_assumptions(DynamicResults& results) const;
  void fill_warnings(DynamicResults& results) const;
  void fill_slamming(DynamicResults& results) const;
  void fill_tensioner_warnings(DynamicResults& results) const;
  void fill_supports(DynamicResults& results) const;
  void fill_regions(DynamicResults& results) const;
  DynamicExtreme extreme_of(const RegionPeak& peak, const Spread& over_time) const;

  const Model* model_;
  const Line* line_;
  const Body* vessel_;
  NodeRecovery recovery_;
  DesignRecorder design_;
  NodeValues nodes_, static_nodes_;
  KeyValues key_;
  std::size_t first_ = 0;                   ///< Node that is recorded.
  int tip_roller_ = -1;                     ///< Bottom roller of the stinger's last row.
  std::optional<double> static_departure_;  ///< Arc length of the last contact in the static state [m].
  std::size_t rollers_, boxes_;

  std::vector<double> node_sample_, support_sample_, static_supports_, key_sample_;
  RunningStatistics node_statistics_, support_statistics_, key_statistics_;
  std::vector<double> reaction_sample_;  ///< Of the boxes.
  RunningQuantiles reaction_quantiles_;
  TensionerAccount tensioner_;
  SurfaceCrossing crossing_;
  std::vector<double> row_, snapshot_;
  std::vector<double> largest_reaction_, least_separation_, largest_key_, least_key_;  ///< Since the last row.
  struct RollerImpacts {
    double count = 0.0, velocity = 0.0, force = 0.0, impulse = 0.0;
  };
  std::vector<RollerImpacts> impacts_;
  struct BoxLeft {
    double time = kNever;  ///< When the pipe was first off the box [s].
    double side = 1.0;     ///< Positive to port.
  };
  std::vector<BoxLeft> left_;
  std::vector<Impact> hardest_;
  double impact_count_ = 0.0;
};

}  // namespace overbend
