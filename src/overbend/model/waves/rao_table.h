/// Motion of the vessel in regular waves: displacement response amplitude operators in the convention of the house.
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

  std::vector<double> headings;              ///< Rising, in [0, 2 pi) [rad].
  std::vector<double> omegas;                ///< Rising, positive [rad/s].
  std::vector<std::complex<double>> values;  ///< [heading][omega][6].
  Vec3 reference_V = Vec3::Zero();           ///< Point of the vessel whose motion this is [m].
  Vec3 wave_origin_V = Vec3::Zero();         ///< Point whose wave crest the phases count from [m].
  std::string source;                        ///< File they were read from.
  bool starboard = false;                    ///< One side only, entered as the mirror image of what the file gives.
  bool asymmetric = false;                   ///< The file says that the sides are not alike: none is mirrored.
  Assumptions assumptions;                   ///< Assumptions where the file states nothing: sentences for the report.

  const std::complex<double>& value(std::size_t heading, std::size_t omega, std::size_t freedom) const {
    return values[(heading * omegas.size() + omega) * 6 + freedom];
  }

  /// True when all headings lie between 0 and 180 deg and the other side is the mirror image.
  bool one_sided() const;

  /// Response at any heading [rad] and frequency [rad/s], interpolated linearly in the complex plane in both.
  ///
  /// Headings are periodic; a table of 0 to 180 deg also applies to the other side by port-starboard symmetry: sway,
  /// roll and yaw change sign. Below the lowest frequency translations hold their value and rotations fall to zero in
  /// proportion to the frequency; above the highest all fade linearly to zero, reached at kFadeOut times that
  /// frequency. The table must not be empty.
  Response at(double heading, double omega) const;

  static constexpr double kFadeOut = 1.25;
};

/// The same responses with phases that count from the crest at midship. Counted from a point far from there, the phase
/// turns by k times the distance from one heading or frequency to the next, and a straight line between them passes too
/// close to zero.
RaoTable counted_from_midship(RaoTable raos, double depth);

/// The same responses of points on the centreline: of one side alone only these are like those of the other.
RaoTable moved_to_centreline(RaoTable raos, double depth);

}  // namespace overbend
