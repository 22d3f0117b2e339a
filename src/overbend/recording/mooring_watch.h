/// What mooring lines saw over a run, and what it was too much for.
#pragma once

#include <string>
#include <vector>

#include "base/finding.h"
#include "model/description/mooring_description.h"
#include "numerics/running_statistics.h"
#include "results/moored_dynamics.h"
#include "system/assembly.h"

namespace overbend {

/// Counts from t = 0 on. The mooring lines stand one after the other among the lines of the system.
class MooringWatch {
 public:
  /// `names`: of the lines of the run, which `moorings` describes; none without moorings.
  MooringWatch(const std::optional<MooringsDescription>& moorings, const std::vector<std::string>& names);

  /// The state at the start of the run.
  void start(const SystemState& state, const Assembly& assembly);
  /// An accepted step of `step` [s]. Nothing is allocated.
  void add(const SystemState& state, const Assembly& assembly, double step);
  /// Points of the lines in a snapshot, all together.
  int points() const;
  /// Puts x, y, z [m] and effective tension [N] of every point to `out`, line by line from anchor to fairlead; returns
  /// where it ends. The points stand at fixed shares of the length: the nodes at the start of the run.
  double* film(const SystemState& state, const Assembly& assembly, double* out) const;
  /// Lines beyond their breaking or working load, their winch's brake, their anchor's holding power; lines that lift
  /// their anchor or hang slack.
  Findings findings() const;
  /// All but slow and wave parts, and clearances.
  std::vector<MooringLineDynamics> results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Peak {
    double value = 0.0, time = 0.0;  ///< [N, s]
  };
  /// What is counted of a line.
  enum Quantity : std::size_t { kFairlead, kAnchor, kOnBed, kUplift, kSlack, kLength, kQuantities };
  struct Happening {
    double time = 0.0;           ///< [s]
    const char* what = nullptr;  ///< One of kHappenings.
  };
  struct Watched {
    std::string name;
    std::optional<double> breaking, working, brake, stall, holding;  ///< [N]
    Peak fairlead, anchor, uplift;
    Peak intact_fairlead, intact_anchor;                 ///< While every line holds.
    double start = 0.0;                                  ///< Tension at the fairlead at the start [N].
    std::vector<double> points;                          ///< Shares of the length.
    std::size_t fairlead_end = 0, anchor_end = 0;        ///< Among the attachments of the system.
    bool slides = false;                                 ///< The anchor, beyond its holding power.
    bool slack = false, renders = false, slips = false;  ///< Now.
    std::optional<double> parted_at;                     ///< [s]
    double rendered = 0.0, slipped = 0.0;                ///< So far [m].
    double held_up_for = 0.0;                            ///< The winch, that could not haul in [s].
    double least_element = 1.0, most_element = 1.0;      ///< Length of the last element, of its own.
    double last_element = 0.0, length = 0.0;             ///< Of the line at the start, and of the whole [m].
    std::vector<Happening> events;
  };
  /// Whether every line holds.
  bool is_intact(const SystemState& state) const;
  void note(std::size_t line, const char* what, double time);
  void watch_slack(std::size_t line, double time);
  void watch_ends(std::size_t line, const SystemState& state);
  void watch_element(std::size_t line, const GivenWay& way, const LineMesh& mesh);
  static void warn_of_winch(const Watched& line, Findings& list);
  void warn_of_shape(std::size_t line, Findings& list) const;
  /// Whether a line was shorter than at the start.
  bool hauled_in(std::size_t line) const;
  void look(const SystemState& state, const Assembly& assembly);
  const LineAssembly& line_of(const Assembly& assembly, std::size_t i) const { return assembly.line(first_ + i); }
  double sample(std::size_t line, Quantity quantity) const { return sample_[kQuantities * line + quantity]; }

  std::vector<Watched> lines_;
  std::size_t first_ = 0;      ///< Number of the first among the lines of the system.
  bool quasi_static_ = false;  ///< No ends that give way, no points in snapshots.
  std::vector<double> sample_;
  RunningStatistics statistics_;
};

}  // namespace overbend
