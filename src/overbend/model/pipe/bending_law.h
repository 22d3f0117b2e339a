/// Bending of a yielding pipe in the form used by the rod: a ring of springs with sliders.
///
///     moment = rest k + sum over j, i of stiffness_i e_ij d_j,    e_ij = k.d_j - slip_ij,    |e_ij| <= limit_i
///
/// The unit vectors d_j point to fibres around the wall; a pair of opposite fibres strains by k.d_j times the radius.
/// Each has sliders in parallel (Besseling 1958, Iwan 1967), so that it unloads elastically, follows the first curve
/// doubled on reversal (Masing 1926) and hardens kinematically. The stiffnesses are such that under monotonic loading
/// the ring reproduces the pipe's own moment curve; a pipe bent in one plane and then in another behaves as its fibres
/// do. The limits are equal for all levels, so that the slips keep their meaning when a section moves.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/pipe/moment_curve.h"

namespace overbend {

inline constexpr int kDirections = 16;    ///< Directions d_j over half the circle.
inline constexpr int kSliders = 8;        ///< Sliders of each direction.
inline constexpr int kStrainPoints = 24;  ///< Curvatures at which the axial strain is tabulated.

/// Cosines and sines of the directions.
struct Directions {
  alignas(64) std::array<double, kDirections> x, y;
};
const Directions& directions();

/// Springs for one wall tension and hoop stress.
struct BendingLevel {
  double z = 0.0;                                  ///< Elevation to which it applies [m].
  std::array<double, kSliders> stiffness{};        ///< Stiffness of each slider in every direction [N m2].
  std::array<double, kStrainPoints> mid_strain{};  ///< Axial strain beyond the elastic strain [-].
};

struct BendingLaw {
  double EI = 0.0;                       ///< [N m2]
  std::array<double, kSliders> limit{};  ///< Curvature towards a fibre at which its sliders slide, increasing [1/m].
  std::array<double, kStrainPoints> curvature{};  ///< Curvatures of the axial strains, increasing [1/m].
  std::vector<BendingLevel> levels;               ///< By increasing z; linear between levels, constant beyond.
  std::optional<FibreCurve> steel;                ///< Without hoop stress; empty if only moments are known.
  double fit_error = 0.0;                         ///< Max. relative moment error of all levels [-].
};

/// Springs between two levels: index of the lower level and weight of the upper.
struct LevelMix {
  int lower = 0;
  double share = 0.0;
  bool operator==(const LevelMix&) const = default;
};
LevelMix level_at(const BendingLaw& law, double z);

/// Returns moment and axial strain beyond the elastic one under monotonic loading.
MomentPoint monotonic(const BendingLaw& law, const LevelMix& mix, double curvature);
/// Returns the axial strain only.
double axis_strain(const BendingLaw& law, const LevelMix& mix, double curvature);

/// Returns the bending stiffness before yield: E I, or the first slope of a moment-curvature table [N m2].
double elastic_bending_stiffness(const SteelDescription& steel);

/// Loads on the wall at an elevation.
struct LevelLoads {
  double z = 0.0;
  WallLoads wall;
};

/// Returns the bending law; empty for `linear`. `levels` by increasing z; laws given as moments are independent of
/// tension and pressure.
std::optional<BendingLaw> bending_law(const SteelDescription& steel, const std::vector<LevelLoads>& levels);

}  // namespace overbend
