/// Samples added to sums. Compiled once per instruction set: the numbers are many and little is done with each, so that
/// what counts is how many a register carries.
#pragma once

namespace overbend {

/// What RunningStatistics keeps of quantities, one after the other; no array overlaps another.
struct StatisticsView {
  double *low, *high, *mean, *squares;
};

/// Weight of a sample, and its share in that of all samples with it.
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
