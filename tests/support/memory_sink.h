/// A sink that keeps all it is given.
#pragma once

#include "results/dynamic_sink.h"

namespace overbend::testing {

class MemorySink : public DynamicSink {
 public:
  std::vector<HistoryColumn> columns;
  std::vector<std::vector<double>> rows, snapshots;
  std::vector<Impact> impacts;
  std::vector<DynamicCheckpoint> checkpoints;

  void begin(const std::vector<HistoryColumn>& wanted, const SnapshotSize&) override { columns = wanted; }
  void row(std::span<const double> values) override { rows.emplace_back(values.begin(), values.end()); }
  void snapshot(double, std::span<const double> values) override {
    snapshots.emplace_back(values.begin(), values.end());
  }
  void impact(const Impact& impact) override { impacts.push_back(impact); }
  void checkpoint(const DynamicCheckpoint& state) override { checkpoints.push_back(state); }

  std::vector<double> column(const std::string& name) const {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (columns[i].name == name) {
        std::vector<double> values;
        for (const std::vector<double>& row : rows) {
          values.push_back(row[i]);
        }
        return values;
      }
    }
    return {};
  }
};

/// A sink that keeps nothing and allocates nothing.
class EmptySink : public DynamicSink {
 public:
  void begin(const std::vector<HistoryColumn>&, const SnapshotSize&) override {}
  void row(std::span<const double>) override {}
  void snapshot(double, std::span<const double>) override {}
  void impact(const Impact&) override {}
  void checkpoint(const DynamicCheckpoint&) override {}
};

}  // namespace overbend::testing
