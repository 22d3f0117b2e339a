/// Bending of a pipe that yields, in the form the rod uses: springs with sliders, all in parallel.
///
///     moment = rest k + sum of stiffness_i e_i,    e_i = k - slip_i,    |e_i| <= limit_i
///
/// k, e_i and slip_i are vectors across the pipe. Under a load that only grows the sum is the polygon through the
/// points (limit_i, M(limit_i)) of the moment curve; on unloading it is elastic, on reversal it follows the curve
/// doubled (Masing 1926), and it hardens kinematically in every plane of bending (Besseling 1958, Iwan 1967). The
/// limits are the same for every level, so that the memory (the slips) means the same wherever a section of pipe is.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/moment_curve.h"

namespace overbend {

inline constexpr int kSprings = 24;

/// Springs for one wall tension and hoop stress.
struct BendingLevel {
  double z = 0.0;                             ///< Height for which it stands [m].
  std::array<double, kSprings> stiffness{};   ///< [N m2]
  double rest = 0.0;                          ///< Stiffness of what never yields [N m2].
  std::array<double, kSprings> mid_strain{};  ///< Of the axis at the limits, beyond the elastic strain [-].
};

struct BendingLaw {
  std::array<double, kSprings> limit{};  ///< Curvature at which each spring slides, rising [1/m].
  std::vector<BendingLevel> levels;      ///< By rising z; linear between, constant beyond.
  std::optional<FibreCurve> steel;       ///< Without hoop stress; absent where only moments are known.
};

/// Springs between two levels: index of the lower and the share of the upper.
struct LevelMix {
  int lower = 0;
  double share = 0.0;
};
LevelMix level_at(const BendingLaw& law, double z);

/// Moment under a load that only grows, and the strain of the axis beyond the elastic one.
MomentPoint monotonic(const BendingLaw& law, const LevelMix& mix, double curvature);

/// What loads the wall at a height.
struct LevelLoads {
  double z = 0.0;
  WallLoads wall;
};

/// Nothing for `linear`. `levels` by rising z; laws given as moments take no notice of tension and pressure.
std::optional<BendingLaw> bending_law(const SteelDescription& steel, const std::vector<LevelLoads>& levels);

}  // namespace overbend
