#include "serve/runs/live_history.h"

namespace overbend {

void LiveHistory::add(const std::vector<HistoryColumn>& columns, std::span<const double> values) {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (columns_.empty()) {
    columns_ = columns;
    values_.resize(columns.size());
  }
  for (std::size_t i = 0; i < values_.size() && i < values.size(); ++i) values_[i].push_back(values[i]);
}

void LiveHistory::clear() {
  const std::lock_guard<std::mutex> hold(mutex_);
  columns_.clear();
  values_.clear();
}

std::vector<HistoryColumn> LiveHistory::columns() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  return columns_;
}

std::vector<double> LiveHistory::values(const std::string& name) const {
  const std::lock_guard<std::mutex> hold(mutex_);
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (columns_[i].name == name) return values_[i];
  }
  return {};
}

}  // namespace overbend
