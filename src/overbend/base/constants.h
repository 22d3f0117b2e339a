/// Numbers that many parts of the program need.
#pragma once

#include <limits>
#include <numbers>

namespace overbend {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kTurn = 2.0 * kPi;         ///< A full turn [rad].
inline constexpr double kDegree = kPi / 180.0;     ///< A degree [rad].
inline constexpr double kToDegrees = 180.0 / kPi;  ///< Degrees in a radian.
inline constexpr double kGravity = 9.80665;        ///< Standard gravity [m/s2]; turns weights into masses.
inline constexpr double kThreeHours = 10800.0;     ///< Reference time of extremes in design criteria [s].
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace overbend
