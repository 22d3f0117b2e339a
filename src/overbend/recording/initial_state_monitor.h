/// Check that a run stays at its initial state as long as nothing excites it.
#pragma once

#include <optional>
#include <vector>

#include "model/model.h"
#include "recording/node_recovery.h"

namespace overbend {

/// Observes the pipe while sea and motions are small: up to a tenth of the build-up, the whole run in calm water. A
/// state that is not a stable equilibrium departs by itself.
class InitialStateMonitor {
 public:
  /// `build_up`: its duration [s]; `moved`: vessel or tensioner move even in calm water.
  InitialStateMonitor(const Model& model, double build_up, bool moved);

  /// Sets the static state.
  void start(const NodeValues& nodes, const VesselPose& vessel);
  /// Adds an accepted step that led to `time` [s]. Allocates nothing.
  void add(const NodeValues& nodes, const VesselPose& vessel, double time);
  struct Departure {
    std::size_t node;
    double distance, time;  ///< [m], [s]
  };
  /// Returns the maximum departure of the pipe if it is to be reported.
  std::optional<Departure> departure() const;
  std::vector<double> save() const { return {max_departure_, node_, time_}; }
  void restore(const std::vector<double>& saved);

 private:
  bool quiet(double time) const;
  Vec3 shoe(const VesselPose& vessel) const;

  Vec3 shoe_V_;
  double build_up_;
  bool calm_;                      ///< Nothing moves during the whole run.
  std::vector<double> x_, y_, z_;  ///< Initial positions of the nodes, W [m].
  Vec3 shoe_W_ = Vec3::Zero();
  double max_departure_ = 0.0, node_ = 0.0, time_ = 0.0;  ///< Displacement beyond that explained by the vessel [m], its
                                                          ///< node and time.
};

}  // namespace overbend
