#include "hull/retardation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hull/damping_interpolation.h"

namespace overbend {
namespace {

constexpr double kTwoOverPi = 2.0 / std::numbers::pi;
constexpr double kUsualExponent = 3.0, kMinExponent = 2.0, kMaxExponent = 6.0;
/// If the exponent changes A_inf by less than this share, A_inf does not determine it.
constexpr double kTailMatters = 5e-3;
constexpr int kCellsOfData = 440;
constexpr double kTailGrowth = 1.01, kTailEnd = 1e4;
/// Band over which A_inf is averaged, share of the maximum frequency: around resonance of heave, roll and pitch, where
/// panel codes are most accurate.
constexpr double kBandFrom = 0.23, kBandTo = 0.6;

double log_distance(double a, double b) {
  // At a node the logarithms of the two adjacent cells cancel.
  const double distance = std::abs(a - b);
  return distance < 1e-9 * (a + b) ? 0.0 : std::log(distance);
}

/// Antiderivative of (alpha + beta x)/(x^2 - w^2) at x, for `alpha`, `beta` = 1 each.
struct Antiderivative {
  double constant, linear;
};
Antiderivative antiderivative(double x, double w) {
  const double below = log_distance(x, w), above = std::log(x + w);
  return {0.5 * (below - above) / w, 0.5 * (below + above)};
}

/// Weights of the nodal values in (2/pi) PV integral of B/(x^2 - w^2).
std::vector<double> ogilvie_weights(const std::vector<double>& nodes, double w) {
  std::vector<double> weights(nodes.size(), 0.0);
  Antiderivative left = antiderivative(nodes[0], w);
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const Antiderivative right = antiderivative(nodes[i + 1], w);
    const double a = nodes[i], b = nodes[i + 1], per_length = kTwoOverPi / (b - a);
    const double constant = right.constant - left.constant, linear = right.linear - left.linear;
    weights[i] += per_length * (b * constant - linear);
    weights[i + 1] += per_length * (linear - a * constant);
    left = right;
  }
  return weights;
}

Mat6 weighted_sum(const std::vector<double>& weights, const std::vector<Mat6>& values) {
  Mat6 sum = Mat6::Zero();
  for (std::size_t i = 0; i < weights.size(); ++i) {
    sum += weights[i] * values[i];
  }
  return sum;
}

/// Indices of the frequencies over which A_inf is averaged: those of the band, all if it contains none.
std::vector<std::size_t> find_band(const HydrodynamicData& data) {
  std::vector<std::size_t> band, all;
  for (std::size_t i = 0; i < data.radiation.size(); ++i) {
    const double share = data.radiation[i].omega / data.radiation.back().omega;
    all.push_back(i);
    if (share >= kBandFrom && share <= kBandTo) {
      band.push_back(i);
    }
  }
  return band.empty() ? all : band;
}

/// 0 to the first frequency, then every interval of the data, in equal cells; then geometric.
std::vector<double> make_nodes(const HydrodynamicData& data) {
  const double last = data.radiation.back().omega, cell = last / kCellsOfData;
  std::vector<double> nodes = {0.0};
  for (const RadiationPoint& point : data.radiation) {
    const double from = nodes.back(), length = point.omega - from;
    const int cells = std::max(1, static_cast<int>(std::ceil(length / cell - 1e-6)));
    for (int k = 1; k <= cells; ++k) {
      nodes.push_back(k == cells ? point.omega : from + length * k / cells);
    }
  }
  while (nodes.back() < kTailEnd * last) {
    nodes.push_back(kTailGrowth * nodes.back());
  }
  return nodes;
}

/// Contribution of the tail to A_inf: sum of weights times (omega/last)^-n.
double tail_sum(const DampingSpectrum& spectrum, const std::vector<double>& weights, std::size_t first, double n) {
  double sum = 0.0;
  for (std::size_t i = first; i < weights.size(); ++i) {
    sum += weights[i] * std::pow(spectrum.omega[i] / spectrum.last, -n);
  }
  return sum;
}

/// Exponent for which `sum(n) * at_last` is `wanted`, by bisection: the sum decreases with n.
double exponent_for(const DampingSpectrum& spectrum, const std::vector<double>& weights, std::size_t first,
                    double at_last, double wanted) {
  const auto excess = [&](double n) { return tail_sum(spectrum, weights, first, n) * at_last - wanted; };
  double low = kMinExponent, high = kMaxExponent;
  const double low_value = excess(low), high_value = excess(high);
  if ((low_value > 0.0) == (high_value > 0.0)) {
    return std::abs(low_value) < std::abs(high_value) ? low : high;
  }
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    ((excess(middle) > 0.0) == (low_value > 0.0) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

Mat6 symmetric(const Mat6& m) {
  return 0.5 * (m + m.transpose());
}

/// Exponent of every pair; the spectrum holds the data and zeros after them.
Mat6 tail_exponents(const DampingSpectrum& spectrum, const HydrodynamicData& data, const std::vector<double>& weights,
                    const Mat6& mean_added_mass, std::size_t last) {
  Mat6 exponents = Mat6::Constant(kUsualExponent);
  if (!data.has_infinite) {
    return exponents;
  }
  const double span =
      tail_sum(spectrum, weights, last + 1, kMinExponent) - tail_sum(spectrum, weights, last + 1, kMaxExponent);
  const Mat6 infinite = symmetric(data.added_mass_infinite);
  const Mat6 wanted = mean_added_mass - infinite - weighted_sum(weights, spectrum.damping);
  for (int i = 0; i < 6; ++i) {
    for (int j = i; j < 6; ++j) {
      const double at_last = spectrum.damping[last](i, j);
      if (std::abs(span * at_last) > kTailMatters * std::abs(infinite(i, j))) {
        exponents(i, j) = exponents(j, i) = exponent_for(spectrum, weights, last + 1, at_last, wanted(i, j));
      }
    }
  }
  return exponents;
}

}  // namespace

namespace {

/// Mean over the radiating modes of the median frequency of their damping.
double typical_frequency(const HydrodynamicData& data) {
  constexpr double kUnheard = 1e-6;  // relative to the strongest mode of its kind
  Vec6 sum = Vec6::Zero(), moment = Vec6::Zero();
  for (std::size_t k = 0; k + 1 < data.radiation.size(); ++k) {
    const RadiationPoint &left = data.radiation[k], &right = data.radiation[k + 1];
    const Vec6 area = (right.omega - left.omega) * (left.damping + right.damping).diagonal().cwiseAbs();
    sum += area;
    moment += 0.5 * (left.omega + right.omega) * area;
  }
  const double strongest[] = {sum.head<3>().maxCoeff(), sum.tail<3>().maxCoeff()};
  double typical = 0.0, modes = 0.0;
  for (int i = 0; i < 6; ++i) {
    if (!(sum(i) > kUnheard * strongest[i / 3])) continue;
    typical += moment(i) / sum(i);
    modes += 1.0;
  }
  return modes > 0.0 ? typical / modes : data.radiation.back().omega;
}

}  // namespace

DampingSpectrum damping_spectrum(const HydrodynamicData& data) {
  DampingSpectrum spectrum;
  spectrum.last = data.radiation.back().omega;
  spectrum.typical = typical_frequency(data);
  spectrum.omega = make_nodes(data);
  spectrum.damping.assign(spectrum.omega.size(), Mat6::Zero());
  const auto last = static_cast<std::size_t>(std::find(spectrum.omega.begin(), spectrum.omega.end(), spectrum.last) -
                                             spectrum.omega.begin());
  interpolate_damping(data, passive_damping(data, spectrum.max_negative_damping),
                      std::span(spectrum.omega).first(last + 1), std::span(spectrum.damping).first(last + 1));

  std::vector<double> weights(spectrum.omega.size(), 0.0);
  Mat6 mean = Mat6::Zero();
  const std::vector<std::size_t> band = find_band(data);
  for (const std::size_t index : band) {
    const std::vector<double> node_weights = ogilvie_weights(spectrum.omega, data.radiation[index].omega);
    for (std::size_t i = 0; i < weights.size(); ++i) {
      weights[i] += node_weights[i] / static_cast<double>(band.size());
    }
    mean += symmetric(data.radiation[index].added_mass) / static_cast<double>(band.size());
  }
  spectrum.tail_exponent = tail_exponents(spectrum, data, weights, mean, last);
  for (std::size_t k = last + 1; k < spectrum.omega.size(); ++k) {
    const double logarithm = std::log(spectrum.omega[k] / spectrum.last);
    spectrum.damping[k] =
        spectrum.damping[last].cwiseProduct((-logarithm * spectrum.tail_exponent).array().exp().matrix());
  }
  spectrum.added_mass = mean - weighted_sum(weights, spectrum.damping);
  return spectrum;
}

Mat6 added_mass_above_infinite(const DampingSpectrum& spectrum, double omega) {
  return weighted_sum(ogilvie_weights(spectrum.omega, omega), spectrum.damping);
}

Mat6 retardation(const DampingSpectrum& spectrum, double time) {
  const auto& w = spectrum.omega;
  const auto& b = spectrum.damping;
  Mat6 sum = Mat6::Zero();
  if (time <= 0.0) {
    for (std::size_t i = 0; i + 1 < w.size(); ++i) {
      sum += 0.5 * (w[i + 1] - w[i]) * (b[i] + b[i + 1]);
    }
    return kTwoOverPi * sum;
  }
  double cosine = 1.0;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {  // by parts: exact for B linear between nodes
    const double next = std::cos(w[i + 1] * time);
    sum += (next - cosine) / (w[i + 1] - w[i]) * (b[i + 1] - b[i]);
    cosine = next;
  }
  return kTwoOverPi * (sum / (time * time) + std::sin(w.back() * time) / time * b.back());
}

std::vector<Mat6> retardation_samples(const DampingSpectrum& spectrum, double interval, int count) {
  std::vector<Mat6> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    samples.push_back(retardation(spectrum, i * interval));
  }
  return samples;
}

namespace {

/// Integral of K from 0 to `time`, (2/pi) integral of B/omega sin(omega t), with B/omega linear between nodes.
Mat6 retardation_integral(const DampingSpectrum& spectrum, double time) {
  const auto& w = spectrum.omega;
  const auto per_omega = [&](std::size_t i) -> Mat6 {
    const std::size_t node = std::max<std::size_t>(i, 1);
    return spectrum.damping[node] / w[node];
  };
  Mat6 sum = Mat6::Zero(), left = per_omega(0);
  const Mat6 first = left;
  double sine = 0.0;
  for (std::size_t i = 0; i + 1 < w.size(); ++i) {
    const Mat6 right = per_omega(i + 1);
    const double next = std::sin(w[i + 1] * time);
    sum += (next - sine) / (w[i + 1] - w[i]) * (right - left);
    sine = next;
    left = right;
  }
  return kTwoOverPi * (sum / (time * time) + (first - std::cos(w.back() * time) * left) / time);
}

/// Number of samples up to the last one at which an entry exceeds a share of its peak.
int samples_that_count(const std::vector<Mat6>& kernel, double share) {
  Mat6 peak = Mat6::Zero();
  for (const Mat6& k : kernel) {
    peak = peak.cwiseMax(k.cwiseAbs());
  }
  for (std::size_t i = kernel.size(); i-- > 0;) {
    if ((kernel[i].cwiseAbs().array() > share * peak.array()).any()) {
      return static_cast<int>(i) + 1;
    }
  }
  return 0;
}

}  // namespace

RadiationSamples convolution_samples(const DampingSpectrum& spectrum) {
  // Relative to the typical frequency, which is 1.09 rad/s for a barge of 120 m.
  constexpr double kInterval = 0.109, kMinMemory = 22.0, kMaxMemory = 87.0, kForgotten = 1e-3;
  const double interval = kInterval / spectrum.typical;
  const auto steps = [&](double time) { return static_cast<int>(std::ceil(time / interval - 1e-9)); };
  const std::vector<Mat6> kernel = retardation_samples(spectrum, interval, steps(kMaxMemory / spectrum.typical) + 1);
  const int last = std::clamp(samples_that_count(kernel, kForgotten), steps(kMinMemory / spectrum.typical),
                              steps(kMaxMemory / spectrum.typical));
  const Mat6 mean = retardation_integral(spectrum, last * interval) / (last * interval);
  RadiationSamples samples;
  samples.interval = interval;
  samples.once.push_back(Mat6::Zero());
  samples.twice.push_back(Mat6::Zero());
  for (int i = 1; i <= last; ++i) {
    const auto index = static_cast<std::size_t>(i);
    samples.once.push_back(retardation_integral(spectrum, i * interval) - i * interval * mean);
    // Trapezoid with its end correction, of fourth order; the mean cancels in the difference of K.
    samples.twice.push_back(samples.twice.back() + 0.5 * interval * (samples.once[index - 1] + samples.once[index]) +
                            interval * interval / 12.0 * (kernel[index - 1] - kernel[index]));
  }
  return samples;
}

}  // namespace overbend
