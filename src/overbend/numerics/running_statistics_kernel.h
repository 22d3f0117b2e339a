/// Accumulation of samples. Compiled once per instruction set: there are many values with few operations each, so that
/// the width of the registers matters.
#pragma once

namespace overbend {

/// Arrays of RunningStatistics by quantity; no array overlaps another.
struct StatisticsView {
  double *low, *high, *mean, *squares;
};

/// Weight of a sample, and its fraction of the total weight including it.
struct SampleWeight {
  double weight, share;
};

namespace isa_baseline {
bool all_finite(const double* values, int count);
void add_samples(const double* values, int count, const SampleWeight& by, const StatisticsView& to);
void add_present_samples(const double* values, int count, double weight, double* weights, const StatisticsView& to);
}  // namespace isa_baseline
namespace isa_avx2 {
bool all_finite(const double* values, int count);
void add_samples(const double* values, int count, const SampleWeight& by, const StatisticsView& to);
void add_present_samples(const double* values, int count, double weight, double* weights, const StatisticsView& to);
}  // namespace isa_avx2
namespace isa_avx512 {
bool all_finite(const double* values, int count);
void add_samples(const double* values, int count, const SampleWeight& by, const StatisticsView& to);
void add_present_samples(const double* values, int count, double weight, double* weights, const StatisticsView& to);
}  // namespace isa_avx512

}  // namespace overbend
