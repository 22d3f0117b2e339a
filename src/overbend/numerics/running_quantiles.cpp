#include "numerics/running_quantiles.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/require.h"

namespace overbend {

RunningQuantiles::RunningQuantiles(std::size_t size, double first_width)
    : width_(size, first_width), zero_(size, 0.0), bins_(size * kBins, 0.0) {}

void RunningQuantiles::add(std::span<const double> values, double weight) {
  const bool good =
      std::all_of(values.begin(), values.end(), [](double value) { return value >= 0.0 && std::isfinite(value); });
  require(values.size() == size() && good && weight >= 0.0,
          "a sample needs one finite non-negative value per quantity and a non-negative weight");
  weight_ += weight;
  for (std::size_t i = 0; i < values.size(); ++i) {
    while (values[i] >= static_cast<double>(kBins) * width_[i]) {
      widen(i);
    }
    const std::size_t bin = static_cast<std::size_t>(values[i] / width_[i]);
    (values[i] == 0.0 ? zero_[i] : bins_[kBins * i + bin]) += weight;
  }
}

void RunningQuantiles::widen(std::size_t quantity) {
  double* bins = bins_.data() + kBins * quantity;
  for (std::size_t i = 0; i < kBins / 2; ++i) {
    bins[i] = bins[2 * i] + bins[2 * i + 1];
  }
  std::fill(bins + kBins / 2, bins + kBins, 0.0);
  width_[quantity] *= 2.0;
}

double RunningQuantiles::at(std::size_t quantity, double share) const {
  require(quantity < size(), "the index of the quantity is below size()");
  const double wanted = share * weight_;
  double sum = zero_[quantity], last = 0.0;
  if (sum >= wanted) {
    return 0.0;
  }
  for (std::size_t i = 0; i < kBins; ++i) {
    const double time = bins_[kBins * quantity + i];
    if (time > 0.0) {
      if (sum + time >= wanted) {
        return (static_cast<double>(i) + (wanted - sum) / time) * width_[quantity];
      }
      last = static_cast<double>(i + 1) * width_[quantity];
    }
    sum += time;
  }
  return last;  // rounding left less than requested
}

std::vector<double> RunningQuantiles::save() const {
  std::vector<double> saved{weight_};
  for (const std::vector<double>* part : {&width_, &zero_, &bins_}) {
    saved.insert(saved.end(), part->begin(), part->end());
  }
  return saved;
}

void RunningQuantiles::restore(std::span<const double> saved) {
  require(saved.size() % (kBins + 2) == 1, "the list has the length of saved running quantiles");
  const std::size_t n = saved.size() / (kBins + 2);
  auto from = saved.begin();
  weight_ = *from++;
  for (auto [part, count] : {std::pair{&width_, n}, std::pair{&zero_, n}, std::pair{&bins_, n * kBins}}) {
    const auto to = from + static_cast<std::ptrdiff_t>(count);
    part->assign(from, to);
    from = to;
  }
}

}  // namespace overbend
