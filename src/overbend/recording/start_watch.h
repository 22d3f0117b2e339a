/// Whether a run stays where it starts as long as nothing moves it.
#pragma once

#include <optional>
#include <vector>

#include "model/model.h"
#include "recording/dynamic_stations.h"

namespace overbend {

/// Looks while neither sea nor motion acts in earnest: up to a tenth of the build-up, all along in calm water. A state
/// that is no stable equilibrium departs by itself.
class StartWatch {
 public:
  /// `build_up`: its duration [s]; `moved`: something moves vessel or tensioner even in calm water.
  StartWatch(const Model& model, double build_up, bool moved);

  /// The static state.
  void start(const NodeValues& nodes, const VesselPose& vessel);
  /// An accepted step that led to `time` [s]. Nothing is allocated.
  void add(const NodeValues& nodes, const VesselPose& vessel, double time);
  struct Departure {
    std::size_t node;
    double distance, time;  ///< [m], [s]
  };
  /// The farthest that the pipe went, where that is worth a warning.
  std::optional<Departure> departure() const;
  std::vector<double> save() const { return {largest_, node_, time_}; }
  void restore(const std::vector<double>& saved);

 private:
  bool quiet(double time) const;
  Vec3 shoe(const VesselPose& vessel) const;

  Vec3 shoe_V_;
  double build_up_;
  bool calm_;                      ///< Nothing moves in the whole run.
  std::vector<double> x_, y_, z_;  ///< Of the nodes at the start, W [m].
  Vec3 shoe_W_ = Vec3::Zero();
  double largest_ = 0.0, node_ = 0.0, time_ = 0.0;  ///< Displacement beyond what the vessel explains [m], where, when.
};

}  // namespace overbend
