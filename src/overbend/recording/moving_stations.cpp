#include "recording/moving_stations.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace overbend {
namespace {

using Quantity = std::vector<double> NodeValues::*;

constexpr std::array<Quantity, 11> kAll = {&NodeValues::effective_tension,
                                           &NodeValues::bending_moment,
                                           &NodeValues::bending_stress,
                                           &NodeValues::von_mises,
                                           &NodeValues::strain,
                                           &NodeValues::vertical_moment,
                                           &NodeValues::curvature,
                                           &NodeValues::external_pressure,
                                           &NodeValues::x,
                                           &NodeValues::y,
                                           &NodeValues::z};
constexpr std::array<Quantity, 4> kLarge = {&NodeValues::bending_stress, &NodeValues::von_mises, &NodeValues::strain,
                                            &NodeValues::curvature};

/// True if a node has a local maximum: interpolation between stations would miss it.
bool peaks_at(const std::vector<double>& values, std::size_t node) {
  return node > 0 && node + 1 < values.size() && values[node] >= values[node - 1] && values[node] >= values[node + 1];
}

}  // namespace

MovingStations::MovingStations(const Model& model, const Line& line, bool moves)
    : model_(&model), line_(&line), moves_(moves), recovery_(model, line), places_(line.mesh.s) {
  station_of_node_.resize(places_.size());
  std::iota(station_of_node_.begin(), station_of_node_.end(), 0);
  if (moves) {
    moments_.resize(places_.size());
    tangents_.resize(places_.size());
    sections_ = recovery_.sections();
    nodes_.resize(places_.size());
  }
}

void MovingStations::recover(const Instant& instant, NodeValues& values) {
  if (!moves_) {
    recovery_.recover(instant.pipe(), instant.pipe_assembly(), instant.water(), values);
    return;
  }
  const std::size_t nodes = line_->mesh.s.size();
  if (recovery_.sections().size() != nodes) {
    recovery_ = NodeRecovery(*model_, *line_);
    nodes_.resize(nodes);
    station_of_node_.resize(nodes);
  }
  recovery_.recover(instant.pipe(), instant.pipe_assembly(), instant.water(), nodes_);
  shift_ = line_->mesh.s.back() - places_.back() + instant.tensioner->travel.q;
  find_stations_of_nodes();
  interpolate(values);
  assign_peaks(values);
}

void MovingStations::find_stations_of_nodes() {
  std::size_t station = 0;
  for (std::size_t node = 0; node < station_of_node_.size(); ++node) {
    const double place = position_at(line_->mesh.s[node]);
    while (station + 1 < places_.size() && places_[station + 1] - place <= place - places_[station]) ++station;
    station_of_node_[node] = static_cast<int>(station);
  }
}

void MovingStations::interpolate(NodeValues& values) {
  const std::vector<double>& s = line_->mesh.s;
  std::size_t below = 0;
  for (std::size_t station = 0; station < places_.size(); ++station) {
    const double arc_length = std::clamp(arc_length_at(places_[station]), s.front(), s.back());
    while (below + 2 < s.size() && s[below + 1] <= arc_length) ++below;
    const double share = (arc_length - s[below]) / (s[below + 1] - s[below]);
    for (const Quantity quantity : kAll) {
      const std::vector<double>& at_nodes = nodes_.*quantity;
      (values.*quantity)[station] = at_nodes[below] + share * (at_nodes[below + 1] - at_nodes[below]);
    }
    const std::size_t nearer = share < 0.5 ? below : below + 1;
    moments_.set(station, (1.0 - share) * recovery_.moments()[below] + share * recovery_.moments()[below + 1]);
    tangents_.set(station, recovery_.tangents()[nearer]);
    sections_[station] = recovery_.sections()[below];
  }
}

void MovingStations::assign_peaks(NodeValues& values) {
  for (std::size_t node = 0; node < station_of_node_.size(); ++node) {
    const double s = line_->mesh.s[node];
    if (position_at(s) < places_.front() || position_at(s) > places_.back()) continue;
    const std::size_t station = static_cast<std::size_t>(station_of_node_[node]);
    for (const Quantity quantity : kLarge) {
      if (peaks_at(nodes_.*quantity, node)) {
        (values.*quantity)[station] = std::max((values.*quantity)[station], (nodes_.*quantity)[node]);
      }
    }
    if (peaks_at(nodes_.bending_moment, node) && nodes_.bending_moment[node] > values.bending_moment[station]) {
      values.bending_moment[station] = nodes_.bending_moment[node];
      moments_.set(station, recovery_.moments()[node]);
      tangents_.set(station, recovery_.tangents()[node]);
      sections_[station] = recovery_.sections()[node];
    }
  }
}

}  // namespace overbend
