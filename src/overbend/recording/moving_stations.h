/// Values at stations that stay at fixed positions along the line, while the pipe and its nodes move through them.
///
/// A position counts from the anchor like the arc length at the start: the distance from the tensioner is the rest of
/// the total length. If no pipe moves through the tensioner, stations are the nodes.
#pragma once

#include <vector>

#include "dynamics/run/simulation.h"
#include "recording/node_recovery.h"

namespace overbend {

class MovingStations {
 public:
  /// Uses the present nodes of `line` as stations. `moves`: pipe will be paid out.
  MovingStations(const Model& model, const Line& line, bool moves);

  /// Recovers the values at the nodes and maps them to the stations in `values`: linear between nodes; for quantities
  /// whose maxima are used (moment, curvature, stresses, strain) a peak is assigned to the nearest station. Allocates
  /// only if the mesh has changed.
  void recover(const Instant& instant, NodeValues& values);

  /// Positions of the stations [m].
  const std::vector<double>& places() const { return places_; }
  /// Returns the position at the present arc length `s` of the mesh [m].
  double position_at(double s) const { return s - shift_; }
  /// Returns the present arc length of the mesh at a position [m].
  double arc_length_at(double place) const { return place + shift_; }

  // Last recovered state, at every station.
  const VectorColumns& moments() const { return moves_ ? moments_ : recovery_.moments(); }
  const VectorColumns& tangents() const { return moves_ ? tangents_ : recovery_.tangents(); }
  const std::vector<int>& sections() const { return moves_ ? sections_ : recovery_.sections(); }
  /// Nearest station of every node.
  const std::vector<int>& station_of_node() const { return station_of_node_; }
  /// Values at every node.
  const NodeValues& at_nodes(const NodeValues& at_stations) const { return moves_ ? nodes_ : at_stations; }

 private:
  void find_stations_of_nodes();
  void interpolate(NodeValues& values);
  void assign_peaks(NodeValues& values);

  const Model* model_;
  const Line* line_;
  bool moves_;
  NodeRecovery recovery_;
  std::vector<double> places_;
  double shift_ = 0.0;
  NodeValues nodes_;
  VectorColumns moments_, tangents_;
  std::vector<int> sections_, station_of_node_;
};

}  // namespace overbend
