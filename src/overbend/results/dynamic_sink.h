/// Output interface of a running dynamic analysis, which keeps its memory independent of the duration. The analysis
/// knows no files: it passes on output rows, snapshots and impacts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/dynamic_results.h"

namespace overbend {

/// A column of the table of histories.
struct HistoryColumn {
  std::string name, units, description;  ///< As in HistorySummary. The first column is always "time".
  bool extreme = false;                  ///< Included in the extremes (values are maxima since the last row).
  bool spectrum = false;                 ///< Included in the spectra.
  bool is_minimum = false;               ///< As `extreme` for minima (values are minima since the last row).
};

/// Complete state of a run for a restart: named arrays, bit for bit.
struct DynamicCheckpoint {
  double time = 0.0;
  struct Array {
    std::string name;
    std::vector<double> values;
  };
  std::vector<Array> arrays;
};

/// Contents of a snapshot.
struct SnapshotSize {
  int stations = 0;     ///< Number of stations of the pipe.
  int line_points = 0;  ///< Number of points of all mooring lines and stand-alone lines.

  bool operator==(const SnapshotSize&) const = default;
};

class DynamicSink {
 public:
  virtual ~DynamicSink() = default;
  /// Called once, before all others. A snapshot holds, for each station, x, y, z [m], effective tension [N] and von
  /// Mises stress [Pa], then the twelve numbers of the vessel's pose: p_WV and R_WV by rows, and then, for each point
  /// of the mooring lines and of the stand-alone lines, x, y, z [m] and effective tension [N].
  virtual void begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) = 0;
  /// Adds a row of the table, with one value for each column.
  virtual void row(std::span<const double> values) = 0;
  virtual void snapshot(double time, std::span<const double> values) = 0;
  virtual void impact(const Impact& impact) = 0;
  /// Writes all of the above, and this state, to disk. A resumed run starts at the last checkpoint: later output is
  /// dropped.
  virtual void checkpoint(const DynamicCheckpoint& state) = 0;
};

}  // namespace overbend
