/// What is recorded of a pipe in time: statistics of every station and support, impacts, code checks, fatigue.
#pragma once

#include <span>
#include <vector>

#include "dynamics/run/simulation.h"
#include "numerics/running_quantiles.h"
#include "numerics/running_statistics.h"
#include "recording/design_recorder.h"
#include "recording/fatigue_recorder.h"
#include "recording/history_columns.h"
#include "recording/moving_stations.h"
#include "recording/start_watch.h"
#include "recording/stinger_watch.h"
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

/// Follows the pipe of a simulation from its static state on, and what holds it: supports, stinger, tensioner.
class PipeRecorder {
 public:
  /// `statics` are the results of the state that the simulation starts from. All have to outlive the recorder.
  PipeRecorder(const Model& model, const StaticResults& statics, const Simulation& simulation);

  /// The static state, once.
  void start(const Instant& at);
  /// An accepted step. Statistics count from t > 0. Nothing is allocated.
  void add(const Instant& at);
  /// Counts an impact that ended; returns it with what it does to pipe and coating.
  Impact add_impact(const EndedImpact& ended);
  /// Forgets what was largest since the last row.
  void forget_interval();
  /// Its part of a row's source.
  void show(RowSource& row) const;

  /// Stations in a snapshot, five numbers each: x, y, z [m], effective tension [N], von Mises stress [Pa].
  int stations() const { return static_cast<int>(places().size() - first_); }
  /// Puts them to `out`; returns where they end.
  double* film(double* out) const;

  double top_tension() const { return key_.top_tension; }  ///< Now [N].
  const NodeValues& nodes() const { return nodes_; }       ///< Now, as recorded last.
  void save(DynamicCheckpoint& checkpoint) const;
  void restore(const DynamicCheckpoint& checkpoint);

  /// Statistics into results; leaves what the recorder does not know.
  void fill(DynamicResults& results) const;

 private:
  void tell_current();
  void count(const Impact& impact, double box_force);
  void recover(const Instant& at);
  DesignInstant design_instant(const Instant& at) const;
  void find_key_values(const Instant& at);
  void find_region_peaks(const Regions& regions, double time);
  void find_slack(double time);
  const RollerContact* last_contact(const Instant& at) const;
  double place_of(const RollerContact& contact) const;
  bool is_cable(const RollerContact& contact) const;
  void find_support_values(const Instant& at);
  bool beside(const Instant& at, std::size_t roller) const;
  double tip_clearance(const Instant& at) const;
  void find_passed(const Instant& at);
  void fill_assumptions(DynamicResults& results) const;
  void fill_findings(DynamicResults& results) const;
  void fill_slamming(DynamicResults& results) const;
  void fill_tensioner_findings(DynamicResults& results) const;
  const std::vector<double>& places() const { return recovery_.places(); }
  void fill_supports(DynamicResults& results) const;
  void fill_regions(DynamicResults& results) const;
  DynamicExtreme extreme_of(const RegionPeak& peak, const Spread& over_time) const;

  const Model* model_;
  const StaticResults* statics_;
  const Line* line_;
  const std::vector<BodyRoller>* body_rollers_;
  MovingStations recovery_;
  DesignRecorder design_;
  std::optional<FatigueRecorder> fatigue_;  ///< Where the model asks for it.
  NodeValues nodes_, static_nodes_;
  KeyValues key_;
  std::size_t first_ = 0;                   ///< Station that is recorded.
  const MoveProfile* move_;                 ///< On which the vessel moves ahead; null where it does not.
  int tip_roller_ = -1;                     ///< Bottom roller of the stinger's last row.
  std::optional<double> static_departure_;  ///< Place of the last contact in the static state [m].
  std::size_t rollers_, boxes_;

  std::vector<double> support_sample_, static_supports_, key_sample_;
  RunningStatistics node_statistics_, support_statistics_, key_statistics_;
  std::vector<double> reaction_sample_;  ///< Of the boxes.
  RunningQuantiles reaction_quantiles_;
  TensionerAccount tensioner_;
  StingerWatch stinger_;
  StartWatch start_;
  SurfaceCrossing crossing_;
  std::vector<double> largest_reaction_, least_separation_, largest_key_, least_key_;  ///< Since the last row.
  struct RollerImpacts {
    double count = 0.0, velocity = 0.0, force = 0.0, impulse = 0.0, of_box = 0.0;
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
