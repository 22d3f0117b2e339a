/// Statistics and limit exceedances of mooring lines.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/description/mooring_description.h"
#include "numerics/running_statistics.h"
#include "results/moored_dynamics.h"
#include "system/assembly.h"

namespace overbend {

/// Counts from t = 0 on. The mooring lines are contiguous among the lines of the system.
class MooringRecorder {
 public:
  /// `names`: the lines of the run, described by `moorings`; empty without moorings.
  MooringRecorder(const std::optional<MooringsDescription>& moorings, const std::vector<std::string>& names);

  /// Sets the state at the start of the run.
  void start(const SystemState& state, const Assembly& assembly);
  /// Adds an accepted step of `step` [s]. Allocates nothing.
  void add(const SystemState& state, const Assembly& assembly, double step);
  /// Number of points of all lines in a snapshot.
  int points() const;
  /// Writes x, y, z [m] and effective tension [N] of every point to `out`, line by line from anchor to fairlead;
  /// returns the end. The points are at fixed fractions of the length: the nodes at the start of the run.
  double* append_snapshot(const SystemState& state, const Assembly& assembly, double* out) const;
  /// Warns of lines beyond their breaking or working load, their winch's brake or their anchor's holding power, and of
  /// lines that lift their anchor or fall slack.
  Findings findings() const;
  /// Returns all results but slow and wave parts, and clearances.
  std::vector<MooringLineDynamics> results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Peak {
    double value = 0.0, time = 0.0;  ///< [N, s]
  };
  /// Recorded quantities of a line.
  enum Quantity : std::size_t { kFairlead, kAnchor, kOnBed, kUplift, kSlack, kLength, kQuantities };
  struct LineEvent {
    double time = 0.0;           ///< [s]
    const char* what = nullptr;  ///< One of kEventNames.
  };
  struct RecordedLine {
    std::string name;
    std::optional<double> breaking, working, brake, stall, holding;  ///< [N]
    Peak fairlead, anchor, uplift;
    Peak intact_fairlead, intact_anchor;                 ///< Peaks while every line holds.
    double start = 0.0;                                  ///< Tension at the fairlead at the start [N].
    std::vector<double> points;                          ///< Fractions of the length.
    std::size_t fairlead_end = 0, anchor_end = 0;        ///< Index among the attachments of the system.
    bool slides = false;                                 ///< True if the anchor drags beyond its holding power.
    bool slack = false, renders = false, slips = false;  ///< Present state.
    std::optional<double> parted_at;                     ///< [s]
    double rendered = 0.0, slipped = 0.0;                ///< Length so far [m].
    double stalled_time = 0.0;                           ///< Time for which the winch could not haul in [s].
    double min_element_ratio = 1.0,
           max_element_ratio = 1.0;           ///< Length of the last element relative to its initial one.
    double last_element = 0.0, length = 0.0;  ///< Initial length of the last element and of the line [m].
    std::vector<LineEvent> events;
  };
  /// True if every line holds.
  bool is_intact(const SystemState& state) const;
  void note(std::size_t line, const char* what, double time);
  void watch_slack(std::size_t line, double time);
  void watch_ends(std::size_t line, const SystemState& state);
  void watch_element(std::size_t line, const PayoutState& payout, const LineMesh& mesh);
  static void warn_of_winch(const RecordedLine& line, Findings& list);
  void warn_of_shape(std::size_t line, Findings& list) const;
  /// True if a line was shorter than at the start.
  bool hauled_in(std::size_t line) const;
  void evaluate(const SystemState& state, const Assembly& assembly);
  const LineAssembly& mooring_line(const Assembly& assembly, std::size_t i) const { return assembly.line(first_ + i); }
  double sample(std::size_t line, Quantity quantity) const { return sample_[kQuantities * line + quantity]; }

  std::vector<RecordedLine> lines_;
  std::size_t first_ = 0;      ///< Number of the first mooring line among the lines of the system.
  bool quasi_static_ = false;  ///< Without line end payout and without points in snapshots.
  std::vector<double> sample_;
  RunningStatistics statistics_;
};

}  // namespace overbend
