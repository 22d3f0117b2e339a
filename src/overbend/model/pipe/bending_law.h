/// Bending of a pipe that yields, in the form the rod uses: a ring of springs with sliders.
///
///     moment = rest k + sum over j, i of stiffness_i e_ij d_j,    e_ij = k.d_j - slip_ij,    |e_ij| <= limit_i
///
/// The unit vectors d_j point to fibres around the wall; a pair of opposite fibres strains by k.d_j times the radius.
/// Each has sliders in parallel (Besseling 1958, Iwan 1967), so that it unloads elastically, follows the first curve
/// doubled on reversal (Masing 1926) and hardens kinematically. The stiffnesses are such that under a load that only
/// grows the ring gives the pipe's own moment curve; a pipe bent in one plane and then in another does what its fibres
/// do. The limits are the same for every level, so that the memory (the slips) means the same wherever a section is.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/pipe/moment_curve.h"

namespace overbend {

inline constexpr int kDirections = 16;    ///< d_j, over half the circle.
inline constexpr int kSliders = 8;        ///< Of each direction.
inline constexpr int kStrainPoints = 24;  ///< Curvatures at which the strain of the axis is known.

/// Cosines and sines of the directions.
struct Directions {
  alignas(64) std::array<double, kDirections> x, y;
};
const Directions& directions();

/// Springs for one wall tension and hoop stress.
struct BendingLevel {
  double z = 0.0;                                  ///< Elevation to which it applies [m].
  std::array<double, kSliders> stiffness{};        ///< Of each slider in every direction [N m2].
  std::array<double, kStrainPoints> mid_strain{};  ///< Of the axis, beyond the elastic strain [-].
};

struct BendingLaw {
  double EI = 0.0;                       ///< [N m2]
  std::array<double, kSliders> limit{};  ///< Curvature towards a fibre at which its sliders slide, rising [1/m].
  std::array<double, kStrainPoints> curvature{};  ///< Of the strains of the axis, rising [1/m].
  std::vector<BendingLevel> levels;               ///< By rising z; linear between, constant beyond.
  std::optional<FibreCurve> steel;                ///< Without hoop stress; absent where only moments are known.
  double fit_error = 0.0;                         ///< Of the moment, relative, the largest of all levels.
};

/// Springs between two levels: index of the lower level and weight of the upper.
struct LevelMix {
  int lower = 0;
  double share = 0.0;
  bool operator==(const LevelMix&) const = default;
};
LevelMix level_at(const BendingLaw& law, double z);

/// Moment under a load that only grows, and the strain of the axis beyond the elastic one.
MomentPoint monotonic(const BendingLaw& law, const LevelMix& mix, double curvature);
/// That strain alone.
double axis_strain(const BendingLaw& law, const LevelMix& mix, double curvature);

/// Bending stiffness of the pipe before it yields: E I, or the first slope of a moment-curvature table [N m2].
double elastic_bending_stiffness(const SteelDescription& steel);

/// What loads the wall at a height.
struct LevelLoads {
  double z = 0.0;
  WallLoads wall;
};

/// Nothing for `linear`. `levels` by rising z; laws given as moments take no notice of tension and pressure.
std::optional<BendingLaw> bending_law(const SteelDescription& steel, const std::vector<LevelLoads>& levels);

}  // namespace overbend
