/// Recording of a pipe: statistics of every station and support, impacts, code checks, fatigue.
#pragma once

#include <span>
#include <vector>

#include "dynamics/run/simulation.h"
#include "numerics/running_quantiles.h"
#include "numerics/running_statistics.h"
#include "recording/design_recorder.h"
#include "recording/fatigue_recorder.h"
#include "recording/history_columns.h"
#include "recording/initial_state_monitor.h"
#include "recording/moving_stations.h"
#include "recording/stinger_recorder.h"
#include "recording/surface_crossing.h"
#include "recording/tensioner_recorder.h"
#include "system/find_regions.h"

namespace overbend {

/// Maximum over a region: at present, and over the run.
struct RegionPeak {
  double present = 0.0;
  double maximum = -1.0, s = 0.0, time = 0.0;
};

/// Key figures at one instant.
struct KeyValues {
  double top_tension = 0.0, bottom_tension = 0.0, lay_back = 0.0, departure_angle = 0.0, tip_clearance = 0.0;
  /// Bending moment, bending stress, von Mises stress, strain. `upper`: overbend, or tower if no support carries load
  /// in the static state.
  RegionPeak upper[4], sagbend[4];
  RegionPeak slack;  ///< Negative of the minimum effective tension along the line.
};

inline constexpr double kNever = 1e300;

/// Records the pipe of a simulation from its static state on, and its supports, stinger and tensioner.
class PipeRecorder {
 public:
  /// `statics` are the results of the initial state of the simulation. All arguments must outlive the recorder.
  PipeRecorder(const Model& model, const StaticResults& statics, const Simulation& simulation);

  /// Sets the static state; called once.
  void start(const Instant& instant);
  /// Adds an accepted step. Statistics count from t > 0. Allocates nothing.
  void add(const Instant& instant);
  /// Counts a finished impact; returns it with its effects on pipe and coating.
  Impact add_impact(const EndedImpact& ended);
  /// Resets the extremes since the last row.
  void reset_interval();
  /// Fills the pipe's part of a row's source.
  void fill_row(RowSource& row) const;

  /// Number of stations in a snapshot, five values each: x, y, z [m], effective tension [N], von Mises stress [Pa].
  int stations() const { return static_cast<int>(places().size() - first_); }
  /// Writes them to `out`; returns the end.
  double* append_snapshot(double* out) const;

  double top_tension() const { return key_.top_tension; }  ///< Present value [N].
  const NodeValues& nodes() const { return nodes_; }       ///< Values of the last step.
  void save(DynamicCheckpoint& checkpoint) const;
  void restore(const DynamicCheckpoint& checkpoint);

  /// Fills the recorded results; leaves the others unchanged.
  void fill(DynamicResults& results) const;

 private:
  void pass_current_effect();
  void count(const Impact& impact, double box_force);
  void recover(const Instant& instant);
  DesignInstant design_instant(const Instant& instant) const;
  void find_key_values(const Instant& instant);
  void find_region_peaks(const Regions& regions, double time);
  void find_slack(double time);
  const RollerContact* last_contact(const Instant& instant) const;
  double contact_position(const RollerContact& contact) const;
  bool is_cable(const RollerContact& contact) const;
  void find_support_values(const Instant& instant);
  bool is_past_side(const Instant& instant, std::size_t roller) const;
  double tip_clearance(const Instant& instant) const;
  void find_left_boxes(const Instant& instant);
  void fill_assumptions(DynamicResults& results) const;
  void fill_findings(DynamicResults& results) const;
  void fill_slamming(DynamicResults& results) const;
  void fill_tensioner_findings(DynamicResults& results) const;
  const std::vector<double>& places() const { return recovery_.places(); }
  void fill_supports(DynamicResults& results) const;
  void fill_regions(DynamicResults& results) const;
  DynamicExtreme make_extreme(const RegionPeak& peak, const SummaryStatistics& over_time) const;

  const Model* model_;
  const StaticResults* statics_;
  const Line* line_;
  const std::vector<BodyRoller>* body_rollers_;
  MovingStations recovery_;
  DesignRecorder design_;
  std::optional<FatigueRecorder> fatigue_;  ///< Set if the model requests fatigue.
  NodeValues nodes_, static_nodes_;
  KeyValues key_;
  std::size_t first_ = 0;                   ///< First recorded station.
  const MoveProfile* move_;                 ///< Profile of the vessel's move ahead; null without a move.
  int tip_roller_ = -1;                     ///< Bottom roller of the stinger's last row.
  std::optional<double> static_departure_;  ///< Position of the last contact in the static state [m].
  std::size_t rollers_, boxes_;

  std::vector<double> support_sample_, static_supports_, key_sample_;
  RunningStatistics node_statistics_, support_statistics_, key_statistics_;
  std::vector<double> reaction_sample_;  ///< Reactions of the boxes [N].
  RunningQuantiles reaction_quantiles_;
  TensionerRecorder tensioner_;
  StingerRecorder stinger_;
  InitialStateMonitor start_;
  SurfaceCrossing crossing_;
  std::vector<double> max_reaction_, min_separation_, max_key_, min_key_;  ///< Extremes since the last row.
  struct RollerImpacts {
    double count = 0.0, velocity = 0.0, force = 0.0, impulse = 0.0, of_box = 0.0;
  };
  std::vector<RollerImpacts> impacts_;
  struct BoxDeparture {
    double time = kNever;  ///< Time at which the pipe first left the box [s].
    double side = 1.0;     ///< Positive to port.
  };
  std::vector<BoxDeparture> departures_;
  std::vector<Impact> hardest_;
  double impact_count_ = 0.0;
};

}  // namespace overbend
