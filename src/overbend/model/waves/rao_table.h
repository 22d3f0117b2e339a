/// Motion of the vessel in regular waves: displacement response amplitude operators in the house convention.
#pragma once

#include <array>
#include <complex>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/vec.h"

namespace overbend {

/// The six freedoms of a rigid vessel in the order used everywhere: surge, sway, heave, roll, pitch, yaw.
inline constexpr std::array<const char*, 6> kFreedomNames = {"surge", "sway", "heave", "roll", "pitch", "yaw"};

/// Complex displacement RAOs.
///
/// Per unit wave amplitude a, with the wave's crest over `wave_origin_V` at t = 0:
///   motion = Re(z a exp(i omega t)),  z = amplitude exp(-i lag).
/// Axes V (x forward, y port, z up): surge forward, sway to port, heave up [m/m]; roll starboard down, pitch bow down,
/// yaw bow to port [rad/m]. The heading is the direction in which the waves travel, anticlockwise from +x.
struct RaoTable {
  using Response = std::array<std::complex<double>, 6>;

  std::vector<double> headings;              ///< Increasing, in [0, 2 pi) [rad].
  std::vector<double> omegas;                ///< Increasing, positive [rad/s].
  std::vector<std::complex<double>> values;  ///< [heading][omega][6].
  Vec3 reference_V = Vec3::Zero();           ///< Point of the vessel to which the motion refers [m].
  Vec3 wave_origin_V = Vec3::Zero();         ///< Phase reference: point of the wave crest [m].
  std::string source;                        ///< Source file.
  bool starboard = false;                    ///< One side only, stored as the mirror image of the file's values.
  bool asymmetric = false;                   ///< The file states that the sides differ: no mirroring.
  Assumptions assumptions;                   ///< Assumptions where the file states nothing: sentences for the report.

  const std::complex<double>& value(std::size_t heading, std::size_t omega, std::size_t freedom) const {
    return values[(heading * omegas.size() + omega) * 6 + freedom];
  }

  /// Returns true if all headings are between 0 and 180 deg and the other side is the mirror image.
  bool one_sided() const;

  /// Returns the response at any heading [rad] and frequency [rad/s], interpolated linearly in the complex plane in
  /// both.
  ///
  /// Headings are periodic; a table of 0 to 180 deg also applies to the other side by port-starboard symmetry: sway,
  /// roll and yaw change sign. Below the lowest frequency translations are constant and rotations decrease to zero in
  /// proportion to the frequency; above the highest all decrease linearly to zero, reached at kFadeOut times that
  /// frequency. The table must not be empty.
  Response at(double heading, double omega) const;

  static constexpr double kFadeOut = 1.25;
};

/// Returns the responses with phases relative to the crest at midship. Relative to a distant point the phase changes by
/// k times the distance between headings or frequencies, and linear interpolation passes too close to zero.
RaoTable with_phases_from_midship(RaoTable raos, double depth);

/// Returns the responses of points on the centreline; only for these are both sides mirror images.
RaoTable transferred_to_centreline(RaoTable raos, double depth);

}  // namespace overbend
