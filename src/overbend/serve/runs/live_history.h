/// Histories of the active run so far.
#pragma once

#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// Written by the thread of the run, read by others; cleared at the end of the run. A row takes as much memory as a row
/// of the store on disk.
class LiveHistory {
 public:
  void add(const std::vector<HistoryColumn>& columns, std::span<const double> values);
  void clear();

  /// Returns the columns, time first; empty before the first row.
  std::vector<HistoryColumn> columns() const;
  /// Returns the values so far; empty for an unknown name.
  std::vector<double> values(const std::string& name) const;

 private:
  mutable std::mutex mutex_;
  std::vector<HistoryColumn> columns_;
  std::vector<std::vector<double>> values_;
};

}  // namespace overbend
