/// Closest points of a line and many rollers, as many at once as a register holds. roller_contact.h has the same one by
/// one, which is the reference, and tells what is what. Compiled once per instruction set; raw pointers only, see
/// wave_kernel.h.
#pragma once

namespace overbend {

/// A line as rollers meet it: six values per node, place and tangent, and their rates; unstressed length by element.
struct RolledLine {
  const double *q, *v, *length;
};

/// A roller in W, and where the line's closest point was: it is looked for in that element alone, from that xi on.
struct RollerLook {
  const double *center, *axis, *normal;  ///< Three each, see PlacedRoller.
  double half_face = 0.0, xi = 0.5;
  int element = 0;  ///< Of the closest point to the end of the roller, where the line lies beyond the face.
  int passing = 0;  ///< Where it passes the roller's axis; within the face the closest point is there.
};

/// Where the line meets a roller, see ClosestPoint and RollerDistance.
struct RollerMeeting {
  bool found;  ///< False where the closest point is not in the element that it is looked for in.
  bool beyond_face;
  int element, passing;
  double xi, off_end, distance;
  double place[3], tangent[3];  ///< Of the centreline.
  double velocity[3];           ///< Of the centreline [m/s].
  double reference[3], direction[3];
  double shape[4];  ///< Values of the element's functions there, see HermiteValues.
};

namespace isa_baseline {
void meet_rollers(const RolledLine& line, const RollerLook* looks, int count, RollerMeeting* meetings);
}  // namespace isa_baseline
namespace isa_avx2 {
void meet_rollers(const RolledLine& line, const RollerLook* looks, int count, RollerMeeting* meetings);
}  // namespace isa_avx2
namespace isa_avx512 {
void meet_rollers(const RolledLine& line, const RollerLook* looks, int count, RollerMeeting* meetings);
}  // namespace isa_avx512

}  // namespace overbend
