#include "numerics/log_weibull.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "numerics/random_draw.h"

namespace overbend {
namespace {

constexpr std::size_t kMaxSimulatedTail = 200;
constexpr int kSimulations = 1000;
/// Twice the predicted gain in log-likelihood of a further Newton step, below which the iteration stops: the step is
/// then 1e-4 standard errors, and the error its square. Rounding of sums of a hundred thousand terms is a thousand
/// times smaller.
constexpr double kCloseEnough = 1e-8;
constexpr double kNormal975 = 1.959963984540054;  ///< 97.5 % point of the normal distribution.

/// Log-likelihood in p = 1/scale and q = location/scale of the standardised values, with its derivatives.
struct Likelihood {
  double value = 0.0, p = 0.0, q = 0.0, pp = 0.0, pq = 0.0, qq = 0.0;
};

Likelihood likelihood(std::span<const double> y, std::size_t below, double p, double q) {
  Likelihood l;
  const double n = static_cast<double>(y.size());
  l.value = n * std::log(p);
  l.p = n / p;
  l.pp = -n / (p * p);
  for (const double yi : y) {
    const double z = p * yi - q;
    const double w = std::exp(z);
    l.value += z - w;
    l.p += yi * (1.0 - w);
    l.q += w - 1.0;
    l.pp -= yi * yi * w;
    l.pq += yi * w;
    l.qq -= w;
  }
  if (below > 0) {  // each adds log F of the smallest value of the tail
    const double count = static_cast<double>(below);
    const double w = std::exp(p * y.front() - q);
    const double share = -std::expm1(-w);
    const double first = w * std::exp(-w) / share;
    const double second = first * (1.0 - w - first);
    l.value += count * std::log(share);
    l.p += count * first * y.front();
    l.q -= count * first;
    l.pp += count * second * y.front() * y.front();
    l.pq -= count * second * y.front();
    l.qq += count * second;
  }
  return l;
}

struct Standardised {
  std::vector<double> y;
  double centre = 0.0, spread = 0.0;
};

Standardised standardised(std::span<const double> tail) {
  Standardised s;
  const double n = static_cast<double>(tail.size());
  double squares = 0.0;
  for (const double y : tail) {
    s.centre += y / n;
  }
  for (const double y : tail) {
    squares += (y - s.centre) * (y - s.centre);
  }
  s.spread = std::sqrt(squares / n);
  s.y.reserve(tail.size());
  for (const double y : tail) {
    s.y.push_back((y - s.centre) / s.spread);
  }
  return s;
}

/// Transforms the fit of the standardised values back to the given ones; the covariance by the delta method.
LogWeibull in_given_units(const Standardised& s, const Likelihood& l, double p, double q) {
  const double det = l.pp * l.qq - l.pq * l.pq;
  const double var_p = -l.qq / det;
  const double var_q = -l.pp / det;
  const double cov_pq = l.pq / det;
  // location = centre + spread q/p, scale = spread/p
  const double lp = -s.spread * q / (p * p), lq = s.spread / p, sp = -s.spread / (p * p);
  LogWeibull fit;
  fit.location = s.centre + s.spread * q / p;
  fit.scale = s.spread / p;
  fit.variance[0] = lp * lp * var_p + 2.0 * lp * lq * cov_pq + lq * lq * var_q;
  fit.variance[1] = sp * (lp * var_p + lq * cov_pq);
  fit.variance[2] = sp * sp * var_p;
  return fit;
}

/// Returns the largest `tail` of a random sample with location 0 and scale 1, ascending: exponential spacings give the
/// order statistics of a sample [renyi1953].
std::vector<double> random_tail(std::mt19937_64& generator, std::size_t tail, std::size_t below) {
  std::vector<double> y;
  y.reserve(tail);
  double sum = 0.0;
  for (std::size_t left = tail + below; left > 0; --left) {
    sum -= std::log(uniform_draw(generator)) / static_cast<double>(left);
    if (left <= tail) {
      y.push_back(std::log(sum));
    }
  }
  return y;
}

ConfidentEstimate by_simulation(const LogWeibull& fit, std::size_t tail, std::size_t below, double reduced) {
  std::mt19937_64 generator(20070001);
  std::vector<double> pivots;
  for (int i = 0; i < kSimulations; ++i) {
    if (const auto trial = fit_log_weibull(random_tail(generator, tail, below), below)) {
      pivots.push_back((trial->at(reduced) - reduced) / trial->scale);
    }
  }
  std::sort(pivots.begin(), pivots.end());
  const std::size_t cut = pivots.size() / 40;  // 2.5 % at each end
  const double value = fit.at(reduced);
  return {value, value - fit.scale * pivots[pivots.size() - 1 - cut], value - fit.scale * pivots[cut]};
}

}  // namespace

std::optional<LogWeibull> fit_log_weibull(std::span<const double> tail, std::size_t below) {
  if (tail.size() < 2 || !(tail.back() > tail.front())) {
    return std::nullopt;
  }
  const Standardised s = standardised(tail);
  const double expected_share = static_cast<double>(below) / static_cast<double>(below + tail.size());
  double p = 1.28;  // pi/sqrt(6), from the standard deviation
  double q = below > 0 ? p * s.y.front() - std::log(-std::log1p(-expected_share)) : 0.577;
  Likelihood current = likelihood(s.y, below, p, q);
  for (int i = 0; i < 100; ++i) {
    const double det = current.pp * current.qq - current.pq * current.pq;
    const double step_p = -(current.qq * current.p - current.pq * current.q) / det;
    const double step_q = -(current.pp * current.q - current.pq * current.p) / det;
    const double promise = current.p * step_p + current.q * step_q;  // twice the gain predicted by the quadratic model
    if (promise < kCloseEnough) {
      p += step_p;
      q += step_q;
      return in_given_units(s, likelihood(s.y, below, p, q), p, q);
    }
    double part = 1.0;
    Likelihood next;
    bool gains = false;
    for (; !gains && part > 1e-6; part *= 0.5) {  // the likelihood is concave: a sufficiently short step gains
      if (p + part * step_p > 0.0) {
        next = likelihood(s.y, below, p + part * step_p, q + part * step_q);
        gains = next.value > current.value;
      }
    }
    if (!gains) {
      break;
    }
    p += 2.0 * part * step_p;  // the loop has halved once more
    q += 2.0 * part * step_q;
    current = next;
  }
  return std::nullopt;
}

ConfidentEstimate confident(const LogWeibull& fit, std::size_t tail, std::size_t below, double reduced) {
  if (tail <= kMaxSimulatedTail) {
    return by_simulation(fit, tail, below, reduced);
  }
  const double variance = fit.variance[0] + 2.0 * reduced * fit.variance[1] + reduced * reduced * fit.variance[2];
  const double half = kNormal975 * std::sqrt(variance);
  return {fit.at(reduced), fit.at(reduced) - half, fit.at(reduced) + half};
}

}  // namespace overbend
