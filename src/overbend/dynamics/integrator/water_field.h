/// The moving water along a line, tabulated: waves are evaluated at stations of the line and at moments of a coarse
/// clock, and interpolated in between.
///
///     time     T_j ----------- T_j+1      every `interval`; between, velocities on the cubic through both and their
///                                         rates, accelerations and elevation linear
///     line     o---o---o---o---o          stations close where short waves reach, far apart below; between, linear
///
/// A station is evaluated where the line will be at the moment: extrapolated from where it is when the moment before is
/// reached. So the cost of a sea of hundreds of components does not grow with the steps of an impact. The error is
/// stated in docs/theory/dynamics.md and held by a test.
#pragma once

#include <vector>

#include "mechanics/line_kernel.h"
#include "mechanics/sea.h"
#include "system/line_mesh.h"
#include "system/state.h"
#include "system/system.h"

namespace overbend {

/// The two moments between which time stands; part of the state of a run.
struct WaterMemory {
  double time = 0.0;  ///< Of the first [s].
  std::vector<WaterState> first, second;
};

/// Waves at a point: velocity, acceleration, elevation and pressure head, as LineMotion has them.
using WaterValues = Eigen::Matrix<double, kWaterValues, 1>;

class WaterField {
 public:
  /// Stations by the shape `q` (six per node) of the line; `build_up` in seconds before t = 0.
  WaterField(const Sea& sea, const LineMesh& mesh, const std::vector<double>& q, double build_up, double interval);

  /// With stations at the given nodes, from the first to the last.
  WaterField(const Sea& sea, const LineMesh& mesh, std::vector<int> stations, double build_up, double interval);

  bool calm() const { return stations_.empty(); }
  double interval() const { return interval_; }
  std::size_t stations() const { return stations_.size(); }
  std::size_t nodes() const { return share_.size(); }
  const std::vector<int>& station_nodes() const { return stations_; }

  /// Fills the memory for a run that starts at `time`.
  void start(WaterMemory& memory, double time, const std::vector<double>& q, const std::vector<double>& v);
  /// Fills a memory of another field's stations anew, for a line that is at `q` at a time between its moments.
  void renew(WaterMemory& memory, double now, const std::vector<double>& q, const std::vector<double>& v);
  /// Moves on by one interval: to be called when time reaches the second moment.
  void advance(WaterMemory& memory, const std::vector<double>& q, const std::vector<double>& v);
  /// Waves at all nodes at a time between the moments, kWaterValues each. Does not allocate.
  void nodes_at(const WaterMemory& memory, double time, std::vector<double>& water);

 private:
  void place_between(const LineMesh& mesh);
  void evaluate(double time, const std::vector<double>& q, const std::vector<double>& v, double ahead,
                std::vector<WaterState>& out);

  const Sea* sea_;
  double build_up_, interval_;
  std::vector<int> stations_;       ///< Nodes, from the first to the last.
  std::vector<int> station_below_;  ///< Of every node: the station at or before it.
  std::vector<double> share_;       ///< Of every node: how far it is on to the next station [-].
  std::vector<Vec3> points_;
  std::vector<WaterValues> now_;  ///< At the stations.
};

/// The waves along all lines of a system, with what they remember.
class WaterOnLines {
 public:
  /// Stations by the lines as they are in `state`. The sea must outlive it.
  WaterOnLines(const Sea& sea, const System& system, const SystemState& state, double build_up, double interval);

  bool calm() const { return fields_.empty() || fields_.front().calm(); }
  /// From the time of a state on.
  void start(const SystemState& state);
  /// Moves on by one interval: to be called when time reaches the second moment.
  void advance(const SystemState& state);
  /// Waves at the nodes of all lines, as Surroundings::water; lengths are given on the first call.
  void fill(double time, std::vector<std::vector<double>>& water);
  /// Stations of a line whose mesh has changed, as it is in `state`.
  void renew(std::size_t line, const LineMesh& mesh, const SystemState& state);

  /// Nodes of a line at which its stations are; empty in calm water.
  const std::vector<int>& stations(std::size_t line) const { return fields_[line].station_nodes(); }
  /// Brings a line to such nodes of its mesh, before its memory is restored.
  void place_stations(std::size_t line, const LineMesh& mesh, std::vector<int> nodes);
  const std::vector<WaterMemory>& memories() const { return memories_; }
  std::vector<WaterMemory>& memories() { return memories_; }

 private:
  const Sea* sea_;
  double build_up_, interval_;
  std::vector<WaterField> fields_;  ///< Line by line.
  std::vector<WaterMemory> memories_;
};

/// Time between moments that serves a sea: an eighth of its shortest period, but a whole part of `output_step`.
double water_interval(const Sea& sea, double output_step);

}  // namespace overbend
