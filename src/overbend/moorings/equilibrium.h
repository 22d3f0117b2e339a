/// Rest of a hull on its mooring lines, by dynamic positioning or both: six coordinates, forces of water, lines,
/// thrusters and loads in balance.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "model/description/hull_description.h"
#include "moorings/spread.h"

namespace overbend {

/// Dynamic positioning at rest, where the slow motion is the motion.
struct StationAtRest {
  Vec3 point_V = Vec3::Zero();  ///< The point that is kept, and where the thrust acts [m].
  Vec3 wanted = Vec3::Zero();   ///< Surge and sway of that point, and yaw, from as drawn [m, m, rad].
  StationKeepingDescription law;
};

/// What acts on a hull at rest besides its lines. Axes D: x along the heading as drawn, y port, z up.
struct HullAtRest {
  Mat3 axes_WD = Mat3::Identity();
  double heel = 0.0, pitch = 0.0;         ///< As drawn: starboard down, bow down [rad].
  double length = 100.0;                  ///< Scale of moments [m].
  Mat3 restoring = Mat3::Zero();          ///< Of heave, roll, pitch about its point [N/m, N, N m].
  Vec3 restoring_point_V = Vec3::Zero();  ///< [m]
  /// Force and moment about the reference point that do not change: ballast, pull of the pipe; D [N, N m].
  Vec6 steady = Vec6::Zero();
  /// The same of current, wind and drift with the hull turned by a yaw [rad]; empty where there are none.
  std::function<Vec6(double yaw)> surroundings;
  std::vector<VesselLoadDescription> loads;  ///< Direction kept, point turns with the hull.
  std::optional<StationAtRest> station;
};

/// Surge, sway, heave [m] of midship on the water line from the place as drawn, along D; roll (starboard down), pitch
/// (bow down), yaw (bow to port) [rad], R = Rz Ry Rx in D, on top of what is drawn.
using HullOffset = Vec6;

HullPlace place_of(const HullAtRest& hull, const HullOffset& offset);

/// Which of the six may change.
using FreeModes = std::array<bool, 6>;
inline constexpr FreeModes kAllFree = {true, true, true, true, true, true};
inline constexpr FreeModes kVerticalFree = {false, false, true, true, true, false};

/// Load and derivative of all that acts at an offset, about the reference point, D.
struct HullForces {
  Vec6 total = Vec6::Zero();              ///< Sum [N, N m].
  Vec6 moorings = Vec6::Zero();           ///< Of the lines alone.
  Vec6 station = Vec6::Zero();            ///< Of dynamic positioning alone.
  Vec3 thrust = Vec3::Zero();             ///< Of it: ahead and to port of the hull, bow to port [N, N, N m].
  Mat6 slope = Mat6::Zero();              ///< Minus d(total)/d(offset).
  Mat6 mooring_stiffness = Mat6::Zero();  ///< Minus d(moorings)/d(shift, rotation vector), D.
  Mat6 station_stiffness = Mat6::Zero();  ///< The same of dynamic positioning; angles are taken for small.
  MooringFault fault;
};
HullForces hull_forces(const MooringSpread& spread, const HullAtRest& hull, const HullOffset& offset,
                       std::vector<CatenarySolution>& lines);

struct RestOutcome {
  HullOffset offset = HullOffset::Zero();
  std::vector<CatenarySolution> lines;
  HullForces forces;
  int iterations = 0;
  double residual = 0.0;  ///< Largest unbalanced force over force_scale() (moments over half the length) [-].
  MooringFault fault;
};

/// Newton from `start`, with steps of at most 5 m and 2 deg; cut where they go beyond the least energy on their way.
RestOutcome find_rest(const MooringSpread& spread, const HullAtRest& hull, const HullOffset& start,
                      const FreeModes& free = kAllFree);

/// A stiffness, minus d(force, moment)/d(shift, rotation), about another point of the hull that lies `arm` from its
/// own; `force`: the force whose stiffness it is.
Mat6 stiffness_about(const Mat6& stiffness, const Vec3& force, const Vec3& arm);

/// Lines that pull: neither parted nor slack.
int effective_lines(const MooringSpread& spread, const std::vector<CatenarySolution>& lines);

/// Force scale of the hull's balance: the weight of all lines and what dynamic positioning does a metre off [N].
double force_scale(const MooringSpread& spread, const std::optional<StationKeepingDescription>& station);

/// Whether thrusters give all they can in surge, sway or yaw.
bool thrust_is_exhausted(const HullAtRest& hull, const Vec3& thrust);

}  // namespace overbend
