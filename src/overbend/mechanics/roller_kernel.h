/// Closest points of a line and many rollers, one SIMD register of rollers at a time. roller_contact.h is the scalar
/// reference and defines the quantities. Compiled once per instruction set; raw pointers only, see wave_kernel.h.
#pragma once

namespace overbend {

/// Line data for roller contacts: six values per node, position and tangent, and their rates; unstressed length by
/// element.
struct RolledLine {
  const double *q, *v, *length;
};

/// A roller in W, and the previous position of the closest point: the search is in that element only, from that xi.
struct RollerSearch {
  const double *center, *axis, *normal;  ///< Three each, see PlacedRoller.
  double half_face = 0.0, xi = 0.5;
  int element = 0;  ///< Element of the closest point to the end of the roller, if the line lies beyond the face.
  int passing = 0;  ///< Element where the line passes the roller's axis; within the face it contains the closest point.
};

/// Contact geometry of line and roller, see ClosestPoint and RollerDistance.
struct RollerClosestPoint {
  bool found;  ///< False if the closest point is not in the element of the look.
  bool beyond_face;
  int element, passing;
  double xi, off_end, distance;
  double place[3], tangent[3];  ///< Position and tangent of the centreline.
  double velocity[3];           ///< Velocity of the centreline [m/s].
  double reference[3], direction[3];
  double shape[4];  ///< Values of the shape functions at the point, see HermiteValues.
};

namespace isa_baseline {
void find_closest_points(const RolledLine& line, const RollerSearch* looks, int count, RollerClosestPoint* meetings);
}  // namespace isa_baseline
namespace isa_avx2 {
void find_closest_points(const RolledLine& line, const RollerSearch* looks, int count, RollerClosestPoint* meetings);
}  // namespace isa_avx2
namespace isa_avx512 {
void find_closest_points(const RolledLine& line, const RollerSearch* looks, int count, RollerClosestPoint* meetings);
}  // namespace isa_avx512

}  // namespace overbend
