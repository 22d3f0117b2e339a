/// How the recorder's samples are laid out. For the recorder's own files.
#pragma once

#include <cstddef>

namespace overbend {

inline constexpr std::size_t kNodeQuantities = 8;
inline constexpr std::size_t kBoxQuantities = 6;  ///< Reaction, vertical, longitudinal, lateral, separation, carries.
inline constexpr std::size_t kRollerQuantities = 3;  ///< Reaction, separation, carries.
inline constexpr std::size_t kKeyQuantities = 14;
inline constexpr std::size_t kRegionQuantities = 4;
inline constexpr std::size_t kHardestImpacts = 200;

}  // namespace overbend
