/// Maximum-likelihood fit of the distribution of the logarithm of a Weibull variable, which is also that of a Gumbel
/// variable (of largest values) with its sign turned:
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
  double variance[3] = {};  ///< Of location, of both together (covariance), of scale; from the observed information.

  /// The y at which the exponent (y - location)/scale is `reduced`.
  double at(double reduced) const { return location + scale * reduced; }
};

/// Fit to the largest of a sample, ascending: `tail`; of the `below` others it is known only that they are smaller than
/// tail.front() ([lawless2003], type II censoring). The likelihood is concave in 1/scale and location/scale, so that
/// there is one answer. None when fewer than two values of the tail differ.
std::optional<LogWeibull> fit_log_weibull(std::span<const double> tail, std::size_t below);

/// `fit.at(reduced)` with its 95 % confidence interval, for a fit to `tail` of `tail + below` independent values. Up to
/// 200 in the tail exact but for chance: (estimate - truth)/scale has one distribution whatever location and scale are,
/// and 1,000 fits to random samples (always the same ones) show it. Beyond that normal, from the observed information.
ConfidentEstimate confident(const LogWeibull& fit, std::size_t tail, std::size_t below, double reduced);

}  // namespace overbend
