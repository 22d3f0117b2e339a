#include "study/sampling/latin_hypercube.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/random.h"

namespace overbend {
namespace {

double normal_below(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// Inverse of the normal distribution: Newton's method from a rational start (Abramowitz and Stegun 1964, 26.2.23), to
/// the accuracy of erfc.
double normal_quantile(double p) {
  if (p > 0.5) return -normal_quantile(1.0 - p);
  const double t = std::sqrt(-2.0 * std::log(p));
  double z = -(t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308))));
  for (int i = 0; i < 3; ++i) {
    const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * std::numbers::pi);
    const double newton = (normal_below(z) - p) / density;
    z -= newton / (1.0 + 0.5 * z * newton);  // Halley's step: the density decreases rapidly in the tail
  }
  return z;
}

/// Mean and standard deviation of the logarithm of a log-normal key.
struct LogNormal {
  double mean, std;
  explicit LogNormal(const SampledKey& key) {
    const double variation = key.std / key.mean;
    std = std::sqrt(std::log1p(variation * variation));
    mean = std::log(key.mean) - 0.5 * std * std;
  }
};

/// Probability of a value below x without bounds, for distributions that may have bounds.
double below(const SampledKey& key, double x) {
  if (std::isinf(x)) return x > 0.0 ? 1.0 : 0.0;
  switch (key.distribution) {
    case Distribution::normal:
      return normal_below((x - key.mean) / key.std);
    case Distribution::lognormal: {
      const LogNormal log(key);
      return x > 0.0 ? normal_below((std::log(x) - log.mean) / log.std) : 0.0;
    }
    case Distribution::weibull:
      return x > 0.0 ? -std::expm1(-std::pow(x / key.scale, key.shape)) : 0.0;
    case Distribution::uniform:
    case Distribution::triangular:
      break;
  }
  return (x - key.from) / (key.to - key.from);
}

double triangular_quantile(const SampledKey& key, double p) {
  const double width = key.to - key.from, rise = (key.mode - key.from) / width;
  return p < rise ? key.from + width * std::sqrt(p * rise) : key.to - width * std::sqrt((1.0 - p) * (1.0 - rise));
}

double free_quantile(const SampledKey& key, double p) {
  switch (key.distribution) {
    case Distribution::normal:
      return key.mean + key.std * normal_quantile(p);
    case Distribution::lognormal: {
      const LogNormal log(key);
      return std::exp(log.mean + log.std * normal_quantile(p));
    }
    case Distribution::weibull:
      return key.scale * std::pow(-std::log1p(-p), 1.0 / key.shape);
    case Distribution::triangular:
      return triangular_quantile(key, p);
    case Distribution::uniform:
      break;
  }
  return key.from + (key.to - key.from) * p;
}

std::vector<std::size_t> permutation(std::size_t count, Random& random) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

}  // namespace

double quantile(const SampledKey& key, double p) {
  constexpr double kEdge = 1e-15;  // a quantile of 0 or 1 may be infinite
  const bool cut =
      key.bounded && key.distribution != Distribution::uniform && key.distribution != Distribution::triangular;
  if (!cut) return free_quantile(key, std::clamp(p, kEdge, 1.0 - kEdge));
  const double p_from = below(key, key.from), p_to = below(key, key.to);
  return std::clamp(free_quantile(key, std::clamp(p_from + p * (p_to - p_from), kEdge, 1.0 - kEdge)), key.from, key.to);
}

std::vector<std::vector<double>> latin_hypercube(const StudySample& sample) {
  Random random(sample.seed);
  const auto count = static_cast<std::size_t>(sample.count);
  std::vector<std::vector<double>> draws(count, std::vector<double>(sample.keys.size()));
  for (std::size_t k = 0; k < sample.keys.size(); ++k) {
    const std::vector<std::size_t> order = permutation(count, random);
    for (std::size_t i = 0; i < count; ++i) {
      const double p = (static_cast<double>(order[i]) + random.uniform()) / static_cast<double>(count);
      draws[i][k] = quantile(sample.keys[k], p);
    }
  }
  return draws;
}

}  // namespace overbend
