/// Static equilibrium of a hull on its mooring lines, dynamic positioning or both: six coordinates, balance of
/// hydrostatic forces, line forces, thrust and loads.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "model/description/hull_description.h"
#include "moorings/mooring_spread.h"

namespace overbend {

/// Dynamic positioning in statics, where the low-frequency motion is the whole motion.
struct StaticPositioning {
  Vec3 point_V = Vec3::Zero();  ///< Point that is kept in position and at which the thrust acts [m].
  Vec3 wanted = Vec3::Zero();   ///< Target surge and sway of that point, and yaw, relative to the nominal pose [m, m,
                                ///< rad].
  StationKeepingDescription law;
};

/// Loads on a hull in statics other than its lines. Axes D: x along the nominal heading, y to port, z up.
struct StaticHull {
  Mat3 axes_WD = Mat3::Identity();
  double heel = 0.0, pitch = 0.0;         ///< Nominal attitude: starboard down, bow down [rad].
  double length = 100.0;                  ///< Length scale of moments [m].
  Mat3 restoring = Mat3::Zero();          ///< Hydrostatic stiffness in heave, roll and pitch about `restoring_point_V`
                                          ///< [N/m, N, N m].
  Vec3 restoring_point_V = Vec3::Zero();  ///< [m]
  /// Constant force and moment about the reference point: ballast, pipe load; D [N, N m].
  Vec6 steady = Vec6::Zero();
  /// Force and moment of current, wind and wave drift at a yaw of the hull [rad]; empty if there are none; D [N, N m].
  std::function<Vec6(double yaw)> surroundings;
  std::vector<VesselLoadDescription> loads;  ///< Constant direction; the point turns with the hull.
  std::optional<StaticPositioning> station;
};

/// Surge, sway, heave [m] of midship at the water line from the nominal position, along D; roll (starboard down), pitch
/// (bow down), yaw (bow to port) [rad], R = Rz Ry Rx in D, added to the nominal attitude.
using HullOffset = Vec6;

/// Returns the pose, W, of a hull at an offset.
HullPlace make_hull_place(const StaticHull& hull, const HullOffset& offset);

/// Free coordinates of the six.
using FreeModes = std::array<bool, 6>;
inline constexpr FreeModes kAllFree = {true, true, true, true, true, true};
inline constexpr FreeModes kVerticalFree = {false, false, true, true, true, false};

/// Load on the hull at an offset and its derivative, about the reference point, D.
struct HullForces {
  Vec6 total = Vec6::Zero();              ///< Sum [N, N m].
  Vec6 moorings = Vec6::Zero();           ///< Contribution of the lines.
  Vec6 station = Vec6::Zero();            ///< Contribution of dynamic positioning.
  Vec3 thrust = Vec3::Zero();             ///< Thrust ahead and to port of the hull, and moment, bow to port [N, N, N
                                          ///< m].
  Mat6 slope = Mat6::Zero();              ///< Minus d(total)/d(offset).
  Mat6 mooring_stiffness = Mat6::Zero();  ///< Minus d(moorings)/d(shift, rotation vector), D.
  Mat6 station_stiffness = Mat6::Zero();  ///< Same for dynamic positioning; small angles.
  MooringError error;
};
/// Computes the forces at an offset. `lines`: solutions in the order of the spread, used as a warm start and updated.
HullForces hull_forces(const MooringSpread& spread, const StaticHull& hull, const HullOffset& offset,
                       std::vector<CatenarySolution>& lines);

struct HullEquilibrium {
  HullOffset offset = HullOffset::Zero();
  std::vector<CatenarySolution> lines;
  HullForces forces;
  int iterations = 0;
  double residual = 0.0;  ///< Largest unbalanced force relative to force_scale() (moments over half the length) [-].
  MooringError error;
};

/// Newton from `start` with steps of at most 5 m and 2 deg, shortened where they pass the minimum of energy along them.
HullEquilibrium find_hull_equilibrium(const MooringSpread& spread, const StaticHull& hull, const HullOffset& start,
                                      const FreeModes& free = kAllFree);

/// Transforms a stiffness, minus d(force, moment)/d(shift, rotation), to another point of the hull at `arm` from its
/// own point; `force`: the force that has this stiffness.
Mat6 stiffness_about(const Mat6& stiffness, const Vec3& force, const Vec3& arm);

/// Number of lines under tension: neither parted nor slack.
int effective_lines(const MooringSpread& spread, const std::vector<CatenarySolution>& lines);

/// Force scale of the hull's equilibrium: weight of all lines and the thrust of dynamic positioning at an offset of 1 m
/// [N].
double force_scale(const MooringSpread& spread, const std::optional<StationKeepingDescription>& station);

/// True if the thrust limit is reached in surge, sway or yaw.
bool thrust_is_exhausted(const StaticHull& hull, const Vec3& thrust);

}  // namespace overbend
