/// Least, greatest, mean and standard deviation over time of many quantities at once, in memory that does not grow.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

#include "numerics/running_statistics_kernel.h"

namespace overbend {

/// Statistics of `size` quantities that are sampled together, each sample weighted by the time it represents. Welford's
/// recurrence with weights [west1979]: no differences of large sums, so that a small spread about a large mean keeps
/// its digits. A value that is not a number is absent: the quantity is passed over in that sample.
class RunningStatistics {
 public:
  explicit RunningStatistics(std::size_t size = 0);

  /// Takes a sample of all quantities. `values` has size() entries; `weight` >= 0, a sample of weight 0 counts for min
  /// and max alone. Allocates nothing. Throws std::invalid_argument where either is not so.
  void add(std::span<const double> values, double weight);
  /// The same of a sample in several arrays, one after the other.
  void add_parts(std::initializer_list<std::span<const double>> parts, double weight);

  std::size_t size() const { return min_.size(); }
  double weight() const { return weight_; }  ///< Sum of the weights: the time covered [s].

  // Per quantity. Before the first sample min is +infinity, max -infinity, mean and deviation 0.
  std::span<const double> min() const { return min_; }
  std::span<const double> max() const { return max_; }
  std::span<const double> mean() const { return mean_; }
  std::vector<double> standard_deviation() const;  ///< Of the population: divided by the sum of the weights.

  /// All of it as plain numbers; `restore` brings it back bit for bit, the size included. Throws std::invalid_argument
  /// when `saved` is no such list.
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  // Of the quantities from `first` on.
  StatisticsView view(std::size_t first);
  void add_whole(std::span<const double> values, std::size_t first, double weight);
  void add_there(std::span<const double> values, std::size_t first, double weight);

  double weight_ = 0.0;
  std::vector<double> min_, max_, mean_, squares_;  ///< `squares_`: weighted squared distances from the mean.
  bool all_there_ = true;        ///< No value was absent yet: one weight, and one division a sample, is that of all.
  std::vector<double> weights_;  ///< Of the samples in which the quantity was there; not kept while all were.
};

}  // namespace overbend
