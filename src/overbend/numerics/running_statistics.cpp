#include "numerics/running_statistics.h"

#include <cmath>
#include <limits>

#include "base/require.h"

namespace overbend {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

RunningStatistics::RunningStatistics(std::size_t size)
    : min_(size, kInfinity), max_(size, -kInfinity), mean_(size, 0.0), squares_(size, 0.0), weights_(size, 0.0) {}

void RunningStatistics::add(std::span<const double> values, double weight) {
  require(values.size() == size() && weight >= 0.0,
          "a sample has as many values as there are quantities, and a weight that is not negative");
  weight_ += weight;
  const std::size_t n = values.size();
  // Plain pointers that do not overlap, and no branches: the compiler makes vectors of it.
  const double* __restrict v = values.data();
  double* __restrict low = min_.data();
  double* __restrict high = max_.data();
  double* __restrict mean = mean_.data();
  double* __restrict squares = squares_.data();
  double* __restrict weights = weights_.data();
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
    if (weights_[i] > 0.0) deviation[i] = std::sqrt(squares_[i] / weights_[i]);
  }
  return deviation;
}

std::vector<double> RunningStatistics::save() const {
  std::vector<double> saved{weight_};
  saved.reserve(1 + 5 * size());
  for (const std::vector<double>* part : {&min_, &max_, &mean_, &squares_, &weights_}) {
    saved.insert(saved.end(), part->begin(), part->end());
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
}

}  // namespace overbend
