#include "numerics/welch.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <unsupported/Eigen/FFT>

namespace overbend {
namespace {

constexpr std::size_t kMinSegment = 512, kMaxSegment = 2048;

/// Returns the number of values in a segment.
std::size_t segment_length(std::size_t values) {
  std::size_t length = kMinSegment;
  while (length < kMaxSegment && 8 * length <= values) {  // twice as long still leaves seven, overlapping by half
    length *= 2;
  }
  return std::min(length, values);
}

/// Periodic form, whose overlapping halves add up to one.
std::vector<double> hann(std::size_t length) {
  std::vector<double> window(length);
  for (std::size_t i = 0; i < length; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(length);
    window[i] = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * part);
  }
  return window;
}

}  // namespace

PowerSpectrum power_spectrum(std::span<const double> values, double step) {
  PowerSpectrum spectrum;
  if (values.size() < 8) {
    return spectrum;
  }
  const std::size_t length = segment_length(values.size());
  const std::size_t padded = std::max(length, kMinSegment);
  const std::vector<double> window = hann(length);
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());

  Eigen::FFT<double> fft;
  fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
  std::vector<double> segment(padded, 0.0);
  std::vector<std::complex<double>> transform;
  spectrum.density.assign(padded / 2 + 1, 0.0);
  for (std::size_t from = 0; from + length <= values.size(); from += length / 2) {
    for (std::size_t i = 0; i < length; ++i) {
      segment[i] = window[i] * (values[from + i] - mean);
    }
    fft.fwd(transform, segment);
    for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
      spectrum.density[k] += std::norm(transform[k]);
    }
    ++spectrum.segments;
  }

  const double power = std::inner_product(window.begin(), window.end(), window.begin(), 0.0);
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    const bool alone = k == 0 || 2 * k == padded;  // all others also represent a negative frequency
    spectrum.density[k] *= (alone ? 1.0 : 2.0) * step / (power * spectrum.segments);
    spectrum.frequency.push_back(static_cast<double>(k) / (static_cast<double>(padded) * step));
  }
  return spectrum;
}

}  // namespace overbend
