/// Reads the long data of a dynamic run in results.h5 in parts, as they may exceed the memory.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// Returns the histories of a run, without the time; `extreme` and `spectrum` are not stored. Throws
/// std::runtime_error, as the other functions here, if the file has another layout.
std::vector<HistoryColumn> read_history_columns(const std::filesystem::path& h5);

/// Returns all values of a history, including "time".
std::vector<double> read_history(const std::filesystem::path& h5, const std::string& name);

/// The line and the vessel at successive instants; the values of a snapshot are contiguous, stations as in
/// DynamicResults.
struct SnapshotBlock {
  std::int64_t total = 0;  ///< Number of snapshots of the run.
  std::int64_t stations = 0;
  std::vector<double> time;                                   ///< [s]
  std::vector<double> x, y, z, effective_tension, von_mises;  ///< Frame W [m], [N], [Pa].
  std::vector<double> vessel_position, vessel_axes;           ///< 3 and 9 numbers per snapshot: p_WV, R_WV by rows.
  /// Points of the mooring lines, line by line from anchor to fairlead; see MooringLineDynamics::points.
  std::int64_t line_points = 0;                              ///< Number per snapshot; 0 without lines.
  std::vector<double> line_x, line_y, line_z, line_tension;  ///< Frame W [m], [N].
};

/// Returns the snapshots from `first` on, at most `count`; fewer at the end of the run.
SnapshotBlock read_snapshots(const std::filesystem::path& h5, std::int64_t first, std::int64_t count);

}  // namespace overbend
