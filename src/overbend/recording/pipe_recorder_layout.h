/// Layout of the recorder's samples, for the recorder's own files.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace overbend {

inline constexpr std::size_t kNodeQuantities = 8;
inline constexpr std::size_t kBoxQuantities = 6;     ///< Reaction, vertical, longitudinal, lateral, separation, in
                                                     ///< contact.
inline constexpr std::size_t kRollerQuantities = 3;  ///< Reaction, separation, in contact.
inline constexpr std::size_t kHardestImpacts = 200;

/// Quantities of a region, each with its maximum at the instant.
enum RegionQuantity : std::size_t { kBendingMoment, kBendingStress, kVonMises, kStrain, kRegionQuantities };

/// Key figures; the quantities of each region are contiguous.
enum KeyQuantity : std::size_t {
  kTopTension,
  kBottomTension,
  kLayBack,
  kDepartureAngle,
  kTipClearance,
  kUpper,  ///< Overbend, or tower if no support carries load in the static state.
  kSagbend = kUpper + kRegionQuantities,
  kMinLineTension = kSagbend + kRegionQuantities,
  kKeyQuantities,
};

/// Returns a minimum, or NaN if nothing was compared with it.
inline double or_missing(double minimum) {
  return std::isinf(minimum) ? std::numeric_limits<double>::quiet_NaN() : minimum;
}

}  // namespace overbend
