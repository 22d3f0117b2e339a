/// Maximum-likelihood fit of the distribution of the logarithm of a Weibull variable, which is also that of a negated
/// Gumbel variable (of maxima):
///
///     F(y) = 1 - exp(-exp((y - location)/scale))
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace overbend {

/// Estimate with the ends of its 95 % confidence interval.
struct ConfidentEstimate {
  double value = 0.0, low = 0.0, high = 0.0;
};

struct LogWeibull {
  double location = 0.0, scale = 1.0;
  double variance[3] = {};  ///< Variances of location, covariance of both, of scale; from the observed information.

  /// Returns the y at which the exponent (y - location)/scale is `reduced`.
  double at(double reduced) const { return location + scale * reduced; }
};

/// Fits to the largest values of a sample, ascending: `tail`; the `below` others are only known to be smaller than
/// tail.front() ([lawless2003], type II censoring). The likelihood is concave in 1/scale and location/scale, so that
/// the solution is unique. Empty if the tail has fewer than two different values.
std::optional<LogWeibull> fit_log_weibull(std::span<const double> tail, std::size_t below);

/// Returns `fit.at(reduced)` with its 95 % confidence interval, for a fit to `tail` of `tail + below` independent
/// values. For up to 200 in the tail exact up to sampling: the distribution of (estimate - true value)/scale does not
/// depend on location and scale, and is found from 1,000 fits to random samples with a fixed seed. Beyond that normal,
/// from the observed information.
ConfidentEstimate confident(const LogWeibull& fit, std::size_t tail, std::size_t below, double reduced);

}  // namespace overbend
