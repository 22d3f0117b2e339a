/// Values at stations that stay in their places along the line, while the pipe and its nodes move through them.
///
/// A place counts from the anchor as arc length did at the start: the distance from the tensioner is what is left of
/// the whole length. Where the pipe does not move through its tensioner, stations are the nodes.
#pragma once

#include <vector>

#include "dynamics/run/simulation.h"
#include "recording/dynamic_stations.h"

namespace overbend {

class MovingStations {
 public:
  /// Stations are the nodes of `line` as it is now. `moves`: whether pipe will be paid out.
  MovingStations(const Model& model, const Line& line, bool moves);

  /// Recovers what the nodes have and puts it to the stations in `values`. Between nodes straight; of what is only
  /// looked at for being large (moment, curvature, stresses, strain) a peak counts at the station nearest to it.
  /// Allocates when the mesh has changed, else nothing.
  void recover(const Instant& at, NodeValues& values);

  /// Places of the stations [m].
  const std::vector<double>& places() const { return places_; }
  /// Place of what is at arc length `s` of the mesh now.
  double place_of(double s) const { return s - shift_; }
  /// Arc length of the mesh that is at a place.
  double arc_length_of(double place) const { return place + shift_; }

  // Of the state recovered last, at every station.
  const VectorColumns& moments() const { return moves_ ? moments_ : recovery_.moments(); }
  const VectorColumns& tangents() const { return moves_ ? tangents_ : recovery_.tangents(); }
  const std::vector<int>& sections() const { return moves_ ? sections_ : recovery_.sections(); }
  /// Of every node the station nearest to it.
  const std::vector<int>& station_of_node() const { return station_of_node_; }
  /// Of every node.
  const NodeValues& at_nodes(const NodeValues& at_stations) const { return moves_ ? nodes_ : at_stations; }

 private:
  void find_stations_of_nodes();
  void interpolate(NodeValues& values);
  void take_largest(NodeValues& values);

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
