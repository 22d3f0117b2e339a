/// Where a running dynamic analysis puts what it finds, so that its memory does not grow with the duration. The
/// analysis knows no files: it hands over rows, pictures and impacts.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/dynamic_results.h"

namespace overbend {

/// A column of the table of histories.
struct HistoryColumn {
  std::string name, units, description;  ///< As in HistorySummary. The first column is always "time".
  bool extreme = false;                  ///< Wanted among the extremes (values are the largest since the last row).
  bool spectrum = false;                 ///< Wanted among the spectra.
  bool smallest = false;                 ///< The same of the smallest (values are the smallest since the last row).
};

/// Everything that a run must know to go on: named arrays, bit for bit.
struct DynamicCheckpoint {
  double time = 0.0;
  struct Array {
    std::string name;
    std::vector<double> values;
  };
  std::vector<Array> arrays;
};

/// What a snapshot shows.
struct SnapshotSize {
  int stations = 0;     ///< Of the pipe.
  int line_points = 0;  ///< Of all mooring lines and other lines together.

  bool operator==(const SnapshotSize&) const = default;
};

class DynamicSink {
 public:
  virtual ~DynamicSink() = default;
  /// Once, before anything else. A snapshot holds, for each station, x, y, z [m], effective tension [N] and von Mises
  /// stress [Pa], then the twelve numbers of the vessel's pose: p_WV and R_WV by rows, and then, for each point of the
  /// mooring lines and of the lines that stand by themselves, x, y, z [m] and effective tension [N].
  virtual void begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) = 0;
  /// A row of the table, as many values as columns.
  virtual void row(std::span<const double> values) = 0;
  virtual void snapshot(double time, std::span<const double> values) = 0;
  virtual void impact(const Impact& impact) = 0;
  /// Makes all of the above, and this, safe on disk. A run that is taken up again begins at the last checkpoint: what
  /// came after it is dropped.
  virtual void checkpoint(const DynamicCheckpoint& state) = 0;
};

}  // namespace overbend
