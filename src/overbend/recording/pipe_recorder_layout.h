/// How the recorder's samples are laid out. For the recorder's own files.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace overbend {

inline constexpr std::size_t kNodeQuantities = 8;
inline constexpr std::size_t kBoxQuantities = 6;  ///< Reaction, vertical, longitudinal, lateral, separation, carries.
inline constexpr std::size_t kRollerQuantities = 3;  ///< Reaction, separation, carries.
inline constexpr std::size_t kHardestImpacts = 200;

/// Quantities of a region, each the largest of it at the instant.
enum RegionQuantity : std::size_t { kBendingMoment, kBendingStress, kVonMises, kStrain, kRegionQuantities };

/// Key figures; each region has its quantities in a row.
enum KeyQuantity : std::size_t {
  kTopTension,
  kBottomTension,
  kLayBack,
  kDepartureAngle,
  kTipClearance,
  kUpper,  ///< The overbend, or the tower where no support carries in the static state.
  kSagbend = kUpper + kRegionQuantities,
  kSmallestTension = kSagbend + kRegionQuantities,
  kKeyQuantities,
};

/// Of a least value that nothing was compared with: no value.
inline double or_absent(double least) {
  return std::isinf(least) ? std::numeric_limits<double>::quiet_NaN() : least;
}

}  // namespace overbend
