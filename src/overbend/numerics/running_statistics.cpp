#include "numerics/running_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/require.h"

namespace overbend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Whether no value is absent; also false of infinite values. In four sums, so that the compiler makes vectors of it.
bool whole(std::span<const double> values) {
  std::array<double, 4> nothing{};
  std::size_t i = 0;
  for (; i + 4 <= values.size(); i += 4) {
    for (std::size_t lane = 0; lane < 4; ++lane) nothing[lane] += 0.0 * values[i + lane];
  }
  for (; i < values.size(); ++i) nothing[0] += 0.0 * values[i];
  return (nothing[0] + nothing[1]) + (nothing[2] + nothing[3]) == 0.0;
}

}  // namespace

RunningStatistics::RunningStatistics(std::size_t size)
    : min_(size, kInfinity), max_(size, -kInfinity), mean_(size, 0.0), squares_(size, 0.0), weights_(size, 0.0) {}

void RunningStatistics::add(std::span<const double> values, double weight) {
  add_parts({values}, weight);
}

void RunningStatistics::add_parts(std::initializer_list<std::span<const double>> parts, double weight) {
  std::size_t count = 0;
  for (const std::span<const double>& part : parts) count += part.size();
  require(count == size() && weight >= 0.0,
          "a sample has as many values as there are quantities, and a weight that is not negative");
  if (all_there_ && !std::all_of(parts.begin(), parts.end(), whole)) {
    std::fill(weights_.begin(), weights_.end(), weight_);
    all_there_ = false;
  }
  weight_ += weight;
  std::size_t first = 0;
  for (const std::span<const double>& part : parts) {
    if (all_there_) {
      add_whole(part, first, weight);
    } else {
      add_there(part, first, weight);
    }
    first += part.size();
  }
}

// Arrays do not overlap, as the compiler is told, and nothing branches: it makes vectors of both loops.

void RunningStatistics::add_whole(std::span<const double> values, std::size_t first, double weight) {
  const std::size_t n = values.size();
  const double* v = values.data();
  double* low = min_.data() + first;
  double* high = max_.data() + first;
  double* mean = mean_.data() + first;
  double* squares = squares_.data() + first;
  const double share = weight_ > 0.0 ? weight / weight_ : 0.0;
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    low[i] = v[i] < low[i] ? v[i] : low[i];
    high[i] = v[i] > high[i] ? v[i] : high[i];
    const double from_old = v[i] - mean[i];
    mean[i] += share * from_old;
    squares[i] += weight * from_old * (v[i] - mean[i]);
  }
}

void RunningStatistics::add_there(std::span<const double> values, std::size_t first, double weight) {
  const std::size_t n = values.size();
  const double* v = values.data();
  double* low = min_.data() + first;
  double* high = max_.data() + first;
  double* mean = mean_.data() + first;
  double* squares = squares_.data() + first;
  double* weights = weights_.data() + first;
#pragma GCC ivdep
  for (std::size_t i = 0; i < n; ++i) {
    const bool there = v[i] == v[i];
    const double value = there ? v[i] : mean[i];
    low[i] = v[i] < low[i] ? v[i] : low[i];
    high[i] = v[i] > high[i] ? v[i] : high[i];
    weights[i] += there ? weight : 0.0;
    const double share = weights[i] > 0.0 ? weight / weights[i] : 0.0;
    const double from_old = value - mean[i];
    mean[i] += share * from_old;
    squares[i] += weight * from_old * (value - mean[i]);
  }
}

std::vector<double> RunningStatistics::standard_deviation() const {
  std::vector<double> deviation(size(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    const double weight = all_there_ ? weight_ : weights_[i];
    if (weight > 0.0) deviation[i] = std::sqrt(squares_[i] / weight);
  }
  return deviation;
}

std::vector<double> RunningStatistics::save() const {
  std::vector<double> saved{weight_};
  saved.reserve(1 + 5 * size());
  for (const std::vector<double>* part : {&min_, &max_, &mean_, &squares_}) {
    saved.insert(saved.end(), part->begin(), part->end());
  }
  if (all_there_) {
    saved.resize(1 + 5 * size(), weight_);
  } else {
    saved.insert(saved.end(), weights_.begin(), weights_.end());
  }
  return saved;
}

void RunningStatistics::restore(std::span<const double> saved) {
  require(saved.size() % 5 == 1, "running statistics are restored from what they saved");
  weight_ = saved[0];
  const std::size_t n = saved.size() / 5;
  std::size_t from = 1;
  for (std::vector<double>* part : {&min_, &max_, &mean_, &squares_, &weights_}) {
    part->assign(saved.begin() + static_cast<std::ptrdiff_t>(from),
                 saved.begin() + static_cast<std::ptrdiff_t>(from + n));
    from += n;
  }
  all_there_ = std::all_of(weights_.begin(), weights_.end(), [&](double weight) { return weight == weight_; });
}

}  // namespace overbend
