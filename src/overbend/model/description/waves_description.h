/// Waves as given in the model file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace overbend {

enum class WaveType { none, airy, stokes5, jonswap, pierson_moskowitz, user };

/// Point of a user-defined wave spectrum, one-sided.
struct SpectrumPoint {
  double omega = 0.0;    ///< [rad/s]
  double density = 0.0;  ///< S(omega) [m2 s]
};

struct WavesDescription {
  WaveType type = WaveType::none;
  double hs = 0.0;                  ///< Significant wave height [m].
  double tp = 0.0;                  ///< Peak period [s].
  double height = 0.0;              ///< Regular wave, crest to trough [m].
  double period = 0.0;              ///< Regular wave [s].
  double phase = 0.0;               ///< Regular wave: a crest passes the origin at t = phase/omega [rad].
  double from = 0.0;                ///< Azimuth from which the waves come [rad].
  std::optional<double> gamma;      ///< JONSWAP peak enhancement; DNV-RP-C205 rule if not given.
  std::optional<double> spreading;  ///< Exponent s of cos^2s directional spreading; long-crested if not given.
  int components = 200;
  std::uint64_t seed = 1;
  std::string spectrum_file;  ///< For `user`: CSV of frequency and spectral density.
  /// Contents of the file by increasing frequency; empty if it could not be read.
  std::vector<SpectrumPoint> spectrum;
};

}  // namespace overbend
