#include "mechanics/record_components.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>

#include "base/constants.h"

namespace overbend {
namespace {

using Complex = std::complex<double>;

constexpr double kBridge = 20.0;       ///< [s]
constexpr double kMinPeriod = 0.5;     ///< As for regular waves [s].
constexpr double kNeglected = 1e-7;    ///< Fraction of the variance.
constexpr std::size_t kMinBridge = 4;  ///< Steps.

std::size_t find_prime_factor(std::size_t n) {
  for (std::size_t p = 2; p * p <= n; ++p) {
    if (n % p == 0) return p;
  }
  return n;
}

/// Returns n or the next larger number without prime factors above 5.
std::size_t smooth_number(std::size_t n) {
  for (;; ++n) {
    std::size_t rest = n;
    for (const std::size_t p : {2U, 3U, 5U}) {
      while (rest % p == 0) rest /= p;
    }
    if (rest == 1) return n;
  }
}

/// Discrete Fourier transform: sum of x_j exp(-2 pi i j k/n), by splitting n into its prime factors.
std::vector<Complex> transform(const std::vector<Complex>& x) {
  const std::size_t n = x.size();
  if (n == 1) return x;
  const std::size_t p = find_prime_factor(n), part = n / p;
  std::vector<std::vector<Complex>> parts(p, std::vector<Complex>(part));
  for (std::size_t j = 0; j < n; ++j) parts[j % p][j / p] = x[j];
  for (std::vector<Complex>& piece : parts) piece = transform(piece);
  std::vector<Complex> out(n);
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t q = 0; q < p; ++q) {
      out[k] += parts[q][k % part] * std::polar(1.0, -kTurn * static_cast<double>(q * k % n) / static_cast<double>(n));
    }
  }
  return out;
}

std::size_t bridge_steps(const ElevationRecord& record) {
  const std::size_t last = record.elevation.size() - 1;
  const double seconds = std::min(kBridge, 0.25 * record.duration());
  const auto steps = std::max(kMinBridge, static_cast<std::size_t>(std::ceil(seconds / record.step)));
  return smooth_number(last + steps) - last;
}

/// The record, then the bridge: a period with a mean of zero.
std::vector<Complex> closed(const ElevationRecord& record) {
  const std::vector<double>& y = record.elevation;
  const std::size_t rows = y.size(), steps = bridge_steps(record), last = rows - 1;
  std::vector<Complex> all(y.begin(), y.end());
  std::vector<double> window;
  for (std::size_t j = 1; j < steps; ++j) {
    const double part = static_cast<double>(j) / static_cast<double>(steps);
    const double fade = 0.5 - 0.5 * std::cos(kPi * part);
    const double onward = 2.0 * y[last] - y[last - std::min(j, last)], back = 2.0 * y[0] - y[std::min(steps - j, last)];
    all.emplace_back((1.0 - fade) * onward + fade * back);
    window.push_back(0.5 - 0.5 * std::cos(kTurn * part));
  }
  const double sum = std::accumulate(all.begin(), all.end(), Complex()).real();
  const double area = std::accumulate(window.begin(), window.end(), 0.0);
  for (std::size_t j = 0; j < window.size(); ++j) all[rows + j] -= sum * window[j] / area;
  return all;
}

/// Removes the smallest components that have `fraction` of the variance together.
void remove_negligible(std::vector<RecordComponent>& components, double fraction) {
  std::vector<double> energies;
  for (const RecordComponent& c : components) energies.push_back(c.amplitude * c.amplitude);
  std::sort(energies.begin(), energies.end());
  const double limit = fraction * std::accumulate(energies.begin(), energies.end(), 0.0);
  double sum = 0.0, threshold = 0.0;
  for (const double energy : energies) {
    sum += energy;
    if (sum > limit) {
      threshold = energy;
      break;
    }
  }
  std::erase_if(components, [&](const RecordComponent& c) { return c.amplitude * c.amplitude < threshold; });
}

}  // namespace

double record_bridge(const ElevationRecord& record) {
  return record.elevation.size() < 2 ? 0.0 : record.step * static_cast<double>(bridge_steps(record));
}

std::vector<RecordComponent> record_components(const ElevationRecord& record) {
  if (record.elevation.size() < 2 || !(record.step > 0.0)) return {};
  const std::vector<Complex> values = transform(closed(record));
  const std::size_t n = values.size();
  const double period = record.step * static_cast<double>(n);
  std::vector<RecordComponent> components;
  for (std::size_t k = 1; k <= n / 2 && kMinPeriod * static_cast<double>(k) <= period; ++k) {
    const double both = 2 * k == n ? 1.0 : 2.0;  // a frequency and its negative, except for the highest
    const double amplitude = both * std::abs(values[k]) / static_cast<double>(n);
    if (amplitude > 0.0) {
      components.push_back({amplitude, kTurn * static_cast<double>(k) / period, -std::arg(values[k])});
    }
  }
  remove_negligible(components, kNeglected);
  return components;
}

}  // namespace overbend
