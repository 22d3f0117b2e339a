/// The sea as the model file has it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class WaveType { none, airy, stokes5, jonswap, pierson_moskowitz, user };

/// A row of a user's wave spectrum, one-sided.
struct SpectrumPoint {
  double omega = 0.0;    ///< [rad/s]
  double density = 0.0;  ///< S(omega) [m2 s]
};

struct WavesDescription {
  WaveType type = WaveType::none;
  double hs = 0.0;                  ///< Significant wave height [m].
  double tp = 0.0;                  ///< Peak period [s].
  double height = 0.0;              ///< Of a regular wave, crest to trough [m].
  double period = 0.0;              ///< Of a regular wave [s].
  double phase = 0.0;               ///< Of a regular wave: a crest passes the origin at t = phase/omega [rad].
  double from = 0.0;                ///< Azimuth the waves come from [rad].
  std::optional<double> gamma;      ///< JONSWAP peak enhancement; DNV-RP-C205 rule where not given.
  std::optional<double> spreading;  ///< Exponent s of cos^2s directional spreading; long-crested where not given.
  int components = 200;
  std::uint64_t seed = 1;
  std::string spectrum_file;            ///< For `user`: CSV of frequency and spectral density.
  std::vector<SpectrumPoint> spectrum;  ///< Its points, by increasing frequency; empty when it could not be read.
};

}  // namespace overbend
