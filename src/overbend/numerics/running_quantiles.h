/// Quantiles over time of many quantities at once, in memory that does not grow.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overbend {

/// Histograms of `size` quantities that are never negative and are sampled together, each sample weighted by the time
/// it represents. Every quantity has kBins bins of equal width; where a value goes beyond them, the width doubles and
/// bins join in pairs. So a quantile is known to within 2/kBins of the largest value, whatever the values are and
/// however long they come. Exact zeros are counted apart.
class RunningQuantiles {
 public:
  static constexpr std::size_t kBins = 1024;

  /// `first_width` is the width of the bins to begin with, in the quantities' unit.
  explicit RunningQuantiles(std::size_t size = 0, double first_width = 1.0);

  /// Takes a sample of all quantities. `values` has size() entries, finite, none negative; `weight` >= 0. Allocates
  /// nothing. Throws std::invalid_argument where either is not so.
  void add(std::span<const double> values, double weight);

  std::size_t size() const { return width_.size(); }

  /// The value that `quantity` stays at or below for `share` of the time, 0 to 1; linear within a bin. 0 before the
  /// first sample.
  double at(std::size_t quantity, double share) const;

  /// All of it as plain numbers; `restore` brings it back bit for bit. Throws std::invalid_argument when `saved` is no
  /// such list.
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  void widen(std::size_t quantity);

  double weight_ = 0.0;               ///< Sum of the weights.
  std::vector<double> width_, zero_;  ///< Per quantity: width of its bins, time at zero.
  std::vector<double> bins_;          ///< kBins per quantity: time within each.
};

}  // namespace overbend
