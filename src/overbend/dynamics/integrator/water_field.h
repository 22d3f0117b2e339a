/// Water kinematics along a line, tabulated: waves are evaluated at stations of the line and at the times of a coarse
/// clock, and interpolated in between.
///
///     time     T_j ----------- T_j+1      every `interval`; between, velocities on the cubic through both and their
///                                         rates, accelerations and elevation linear
///     line     o---o---o---o---o          stations close where short waves reach, far apart below; between, linear
///
/// A station is evaluated where the line will be at that time: extrapolated from its position when the previous time is
/// reached. So the cost of a sea of hundreds of components does not grow with the short steps of an impact. The error
/// is stated in docs/theory/dynamics.md and checked by a test.
#pragma once

#include <vector>

#include "mechanics/line_kernel.h"
#include "mechanics/sea.h"
#include "system/line_mesh.h"
#include "system/state.h"
#include "system/system.h"

namespace overbend {

/// Wave tables at the two times around the present; part of the state of a run.
struct WaterMemory {
  double time = 0.0;  ///< Time of the first table [s].
  std::vector<WaterState> first, second;
};

/// Waves at a point: velocity, acceleration, elevation and pressure head, as in LineMotion.
using WaterValues = Eigen::Matrix<double, kWaterValues, 1>;

/// Waves along one line.
class WaterField {
 public:
  /// Chooses stations by the shape `q` (six per node) of the line; `build_up` [s] before t = 0, tables every `interval`
  /// [s].
  WaterField(const Sea& sea, const LineMesh& mesh, const std::vector<double>& q, double build_up, double interval);

  /// Uses the given nodes, from the first to the last, as stations.
  WaterField(const Sea& sea, const LineMesh& mesh, std::vector<int> stations, double build_up, double interval);

  bool calm() const { return stations_.empty(); }
  double interval() const { return interval_; }
  std::size_t stations() const { return stations_.size(); }
  std::size_t nodes() const { return share_.size(); }
  const std::vector<int>& station_nodes() const { return stations_; }

  /// Fills the tables for a run that starts at `time`.
  void start(WaterMemory& memory, double time, const std::vector<double>& q, const std::vector<double>& v);
  /// Fills tables for new stations, for a line that is at `q` at a time between the two tables.
  void renew(WaterMemory& memory, double time, const std::vector<double>& q, const std::vector<double>& v);
  /// Moves on by one interval; to be called when time reaches the second table.
  void advance(WaterMemory& memory, const std::vector<double>& q, const std::vector<double>& v);
  /// Returns in `water` the waves at all nodes at a time between the tables, kWaterValues per node. Does not allocate.
  void nodes_at(const WaterMemory& memory, double time, std::vector<double>& water);

 private:
  void place_between(const LineMesh& mesh);
  void evaluate(double time, const std::vector<double>& q, const std::vector<double>& v, double ahead,
                std::vector<WaterState>& out);

  const Sea* sea_;
  double build_up_, interval_;
  std::vector<int> stations_;       ///< Node numbers, from the first to the last.
  std::vector<int> station_below_;  ///< Per node: station at or before it.
  std::vector<double> share_;       ///< Per node: position between that station and the next, 0 to 1 [-].
  std::vector<Vec3> points_;
  std::vector<WaterValues> now_;  ///< At the stations.
};

/// Waves along all lines of a system, with their tables.
class WaterOnLines {
 public:
  /// Chooses stations by the shapes of the lines in `state`. `sea` must outlive this.
  WaterOnLines(const Sea& sea, const System& system, const SystemState& state, double build_up, double interval);

  bool calm() const { return fields_.empty() || fields_.front().calm(); }
  /// Starts at the time of `state`.
  void start(const SystemState& state);
  /// Moves on by one interval; to be called when time reaches the second table.
  void advance(const SystemState& state);
  /// Returns the waves at the nodes of all lines, as in Surroundings::water; sized on the first call.
  void fill(double time, std::vector<std::vector<double>>& water);
  /// Chooses new stations for a line whose mesh has changed, with its shape in `state`.
  void renew(std::size_t line, const LineMesh& mesh, const SystemState& state);

  /// Returns the nodes of a line at which its stations are; empty in calm water.
  const std::vector<int>& stations(std::size_t line) const { return fields_[line].station_nodes(); }
  /// Sets the stations of a line, before its tables are restored.
  void place_stations(std::size_t line, const LineMesh& mesh, std::vector<int> nodes);
  const std::vector<WaterMemory>& memories() const { return memories_; }
  std::vector<WaterMemory>& memories() { return memories_; }

 private:
  const Sea* sea_;
  double build_up_, interval_;
  std::vector<WaterField> fields_;  ///< Per line.
  std::vector<WaterMemory> memories_;
};

/// Returns the time between wave tables for a sea [s]: an eighth of its shortest period, but an integer fraction of
/// `output_step`.
double water_interval(const Sea& sea, double output_step);

}  // namespace overbend
