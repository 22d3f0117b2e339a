/// Minimum, maximum, mean and standard deviation over time of many quantities at once, in constant memory.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "numerics/running_statistics_kernel.h"

namespace overbend {

/// Statistics of `size` quantities that are sampled together, each sample weighted by the time it represents. Welford's
/// recurrence with weights [west1979]: no differences of large sums, so that a small deviation from a large mean keeps
/// its digits. NaN is a missing value: the quantity is skipped in that sample.
class RunningStatistics {
 public:
  explicit RunningStatistics(std::size_t size = 0);

  /// Adds a sample of all quantities. `values` has size() entries; `weight` >= 0, a sample of weight 0 counts for min
  /// and max only. Does not allocate. Throws std::invalid_argument otherwise.
  void add(std::span<const double> values, double weight);
  /// Adds a sample given in several consecutive arrays.
  void add_parts(std::initializer_list<std::span<const double>> parts, double weight);

  std::size_t size() const { return min_.size(); }
  double weight() const { return weight_; }  ///< Sum of the weights: the time covered [s].

  // Per quantity. Before the first sample min is +infinity, max -infinity, mean and deviation 0.
  std::span<const double> min() const { return min_; }
  std::span<const double> max() const { return max_; }
  std::span<const double> mean() const { return mean_; }
  std::vector<double> standard_deviation() const;  ///< Population value: divided by the sum of the weights.

  /// Returns the state as numbers; `restore` reproduces it bitwise, including the size. Throws std::invalid_argument if
  /// `saved` is not such a list.
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  // For the quantities from `first` on.
  StatisticsView view(std::size_t first);
  void add_complete(std::span<const double> values, std::size_t first, double weight);
  void add_available(std::span<const double> values, std::size_t first, double weight);

  double weight_ = 0.0;
  std::vector<double> min_, max_, mean_, squares_;  ///< `squares_`: weighted squared distances from the mean.
  /// True while no value has been missing: a single weight, and one division per sample, then serves all.
  bool none_missing_ = true;
  /// Total weight of the samples with a value, by quantity; unused while none was missing.
  std::vector<double> weights_;
};

}  // namespace overbend
