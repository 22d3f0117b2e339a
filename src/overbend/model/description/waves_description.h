/// Waves as given in the model file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/vec.h"

namespace overbend {

enum class WaveType { none, airy, stokes5, jonswap, pierson_moskowitz, ochi_hubble, torsethaugen, user, elevation };

/// Form of the Torsethaugen spectrum: simplified of 2004, or the full model of 1996.
enum class TorsethaugenModel { simplified, full };

/// Point of a user-defined wave spectrum, one-sided.
struct SpectrumPoint {
  double omega = 0.0;    ///< [rad/s]
  double density = 0.0;  ///< S(omega) [m2 s]
};

/// Directions of a spectrum from a file, all azimuths from which the waves come: a mean by frequency with a spreading,
/// or a table over sectors of equal width. Empty for a file without directions.
struct SpectrumDirections {
  std::vector<double> from;       ///< Mean azimuth of each point of the spectrum [rad].
  std::vector<double> spreading;  ///< Exponent s of cos^2s of half the angle, of each point; empty: long-crested.
  std::vector<double> sectors;    ///< Middles of the sectors, in order of the azimuth [rad].
  std::vector<double> density;    ///< [point][sector], share of the point's density per angle, any scale.

  bool empty() const { return from.empty() && sectors.empty(); }
};

/// Part of an Ochi-Hubble spectrum.
struct SpectrumPart {
  double hs = 0.0;      ///< Significant wave height [m].
  double tp = 0.0;      ///< Peak period [s].
  double lambda = 0.0;  ///< Shape: 1 is Pierson-Moskowitz, a larger one is more peaked.
};

/// Elevation measured at a point in even steps, without its mean.
struct ElevationRecord {
  double step = 0.0;              ///< [s]
  double mean = 0.0;              ///< Mean that was subtracted [m].
  std::vector<double> elevation;  ///< From t = 0 on [m].

  double duration() const { return elevation.empty() ? 0.0 : step * static_cast<double>(elevation.size() - 1); }
};

/// A group of waves, such as wind sea or swell: a regular wave, a spectrum or a measured elevation.
struct WavesDescription {
  std::string key = "environment.waves";  ///< Path in the model file, "environment.waves[1]" in a list of groups.
  WaveType type = WaveType::none;
  double hs = 0.0;                  ///< Significant wave height [m]; that of the parts or the file if these give it.
  double tp = 0.0;                  ///< Peak period [s]; from `tz` if that is given.
  std::optional<double> tz;         ///< Zero up-crossing period, as given [s].
  std::vector<SpectrumPart> parts;  ///< Parts of an Ochi-Hubble spectrum.
  TorsethaugenModel model = TorsethaugenModel::simplified;
  double height = 0.0;              ///< Regular wave, crest to trough [m].
  double period = 0.0;              ///< Regular wave [s].
  double phase = 0.0;               ///< Regular wave: a crest passes the origin at t = phase/omega [rad].
  double from = 0.0;                ///< Azimuth from which the waves come [rad].
  std::optional<double> gamma;      ///< JONSWAP peak enhancement; DNV-RP-C205 rule if not given.
  std::optional<double> spreading;  ///< Exponent s of cos^2s directional spreading; long-crested if not given.
  int components = 200;
  std::uint64_t seed = 1;
  std::string spectrum_file;        ///< For `user`: spectrum; for wind seas: sea states of a buoy.
  std::string time;                 ///< Time in a file of several.
  std::optional<int> location;      ///< Location in a file of several, from 1.
  std::string elevation_file;       ///< For `elevation`.
  Vec3 measured_at = Vec3::Zero();  ///< Place of the measured elevation, x and y [m].
  /// Contents of the file by increasing frequency; empty if it could not be read.
  std::vector<SpectrumPoint> spectrum;
  SpectrumDirections directions;      ///< Directions in the file.
  bool file_gives_direction = false;  ///< True if `from` is that of the file, of several directions the mean.
  ElevationRecord record;             ///< Contents of the elevation file; empty if it could not be read.
  Assumptions assumptions;            ///< Conversions and interpretations of the readers.
};

}  // namespace overbend
