/// Quantiles over time of many quantities at once, in constant memory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace overbend {

/// Histograms of `size` non-negative quantities that are sampled together, each sample weighted by the time it
/// represents. Every quantity has kBins bins of equal width; when a value exceeds their range, the width doubles and
/// bins are merged in pairs. A quantile is therefore accurate to 2/kBins of the maximum value, for any values and any
/// duration. Exact zeros are counted separately.
class RunningQuantiles {
 public:
  static constexpr std::size_t kBins = 1024;

  /// `first_width` is the initial width of the bins, in the quantities' unit.
  explicit RunningQuantiles(std::size_t size = 0, double first_width = 1.0);

  /// Adds a sample of all quantities. `values` has size() entries, finite and non-negative; `weight` >= 0. Does not
  /// allocate. Throws std::invalid_argument otherwise.
  void add(std::span<const double> values, double weight);

  std::size_t size() const { return width_.size(); }

  /// Returns the value that `quantity` does not exceed for the fraction `share` of the time, 0 to 1; linear within a
  /// bin. 0 before the first sample.
  double at(std::size_t quantity, double share) const;

  /// Returns the state as numbers; `restore` reproduces it bitwise. Throws std::invalid_argument if `saved` is not such
  /// a list.
  std::vector<double> save() const;
  void restore(std::span<const double> saved);

 private:
  void widen(std::size_t quantity);

  double weight_ = 0.0;               ///< Sum of the weights.
  std::vector<double> width_, zero_;  ///< Per quantity: width of its bins, time at zero.
  std::vector<double> bins_;          ///< kBins per quantity: time within each.
};

}  // namespace overbend
