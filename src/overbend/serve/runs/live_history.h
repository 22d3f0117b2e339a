/// Histories of the run that is running, as far as it has come.
#pragma once

#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "results/dynamic_sink.h"

namespace overbend {

/// Written by the run's thread, read by others. A row of it costs what a row of the store on disk does; it lives as
/// long as the run is running.
class LiveHistory {
 public:
  void add(const std::vector<HistoryColumn>& columns, std::span<const double> values);
  void clear();

  /// With the time, the first of all; empty before the first row.
  std::vector<HistoryColumn> columns() const;
  /// Values so far, empty for a name that there is none of.
  std::vector<double> values(const std::string& name) const;

 private:
  mutable std::mutex mutex_;
  std::vector<HistoryColumn> columns_;
  std::vector<std::vector<double>> values_;
};

}  // namespace overbend
