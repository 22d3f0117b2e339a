#include "numerics/running_statistics.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/require.h"
#include "base/simd.h"

namespace overbend {
namespace {

struct StatisticsKernels {
  bool (*all_finite)(const double* values, int count);
  void (*add)(const double* values, int count, const SampleWeight& by, const StatisticsView& to);
  void (*add_present)(const double* values, int count, double weight, double* weights, const StatisticsView& to);
};

StatisticsKernels kernels() {
#if defined(OVERBEND_X86_KERNELS)
  if (best_isa() == Isa::avx512) {
    return {isa_avx512::all_finite, isa_avx512::add_samples, isa_avx512::add_present_samples};
  }
  if (best_isa() == Isa::avx2) {
    return {isa_avx2::all_finite, isa_avx2::add_samples, isa_avx2::add_present_samples};
  }
#endif
  return {isa_baseline::all_finite, isa_baseline::add_samples, isa_baseline::add_present_samples};
}

/// True if no value is missing; also false for infinite values.
bool has_no_missing(std::span<const double> values) {
  return kernels().all_finite(values.data(), static_cast<int>(values.size()));
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
  require(count == size() && weight >= 0.0, "a sample needs one value per quantity and a non-negative weight");
  if (none_missing_ && !std::all_of(parts.begin(), parts.end(), has_no_missing)) {
    std::fill(weights_.begin(), weights_.end(), weight_);
    none_missing_ = false;
  }
  weight_ += weight;
  std::size_t first = 0;
  for (const std::span<const double>& part : parts) {
    if (none_missing_) {
      add_complete(part, first, weight);
    } else {
      add_available(part, first, weight);
    }
    first += part.size();
  }
}

StatisticsView RunningStatistics::view(std::size_t first) {
  return {min_.data() + first, max_.data() + first, mean_.data() + first, squares_.data() + first};
}

void RunningStatistics::add_complete(std::span<const double> values, std::size_t first, double weight) {
  const double share = weight_ > 0.0 ? weight / weight_ : 0.0;
  kernels().add(values.data(), static_cast<int>(values.size()), {weight, share}, view(first));
}

void RunningStatistics::add_available(std::span<const double> values, std::size_t first, double weight) {
  kernels().add_present(values.data(), static_cast<int>(values.size()), weight, weights_.data() + first, view(first));
}

std::vector<double> RunningStatistics::standard_deviation() const {
  std::vector<double> deviation(size(), 0.0);
  for (std::size_t i = 0; i < size(); ++i) {
    const double weight = none_missing_ ? weight_ : weights_[i];
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
  if (none_missing_) {
    saved.resize(1 + 5 * size(), weight_);
  } else {
    saved.insert(saved.end(), weights_.begin(), weights_.end());
  }
  return saved;
}

void RunningStatistics::restore(std::span<const double> saved) {
  require(saved.size() % 5 == 1, "the list has the length of saved running statistics");
  weight_ = saved[0];
  const std::size_t n = saved.size() / 5;
  std::size_t from = 1;
  for (std::vector<double>* part : {&min_, &max_, &mean_, &squares_, &weights_}) {
    part->assign(saved.begin() + static_cast<std::ptrdiff_t>(from),
                 saved.begin() + static_cast<std::ptrdiff_t>(from + n));
    from += n;
  }
  none_missing_ = std::all_of(weights_.begin(), weights_.end(), [&](double weight) { return weight == weight_; });
}

}  // namespace overbend
