/// Contact between the pipe's centreline and one roller: a rigid finite cylinder that holds the pipe on its desired
/// side.
///
///      normal        o   pipe axis r(xi)
///        ^           |
///        |           |   d: distance of the centreline to the roller's axis, on the side of the normal
///        |           |
///     ===|===========o=====   roller axis (C, a), half a face either way of C
///
/// The closest point between the C1 centreline and the axis is at a continuous xi along the element, so that
/// sliding from one element to the next never changes the force. Within the face the distance is that of the centreline
/// projected along the roller's axis (the axis is a line); beyond the face it is the distance to the end of the axis,
/// so that the pipe runs off over a rounded end.
#pragma once

#include <span>

#include "base/simd.h"
#include "mechanics/rod_element.h"
#include "mechanics/roller_kernel.h"
#include "model/vessel/supports.h"

namespace overbend {

/// A roller placed in W.
struct PlacedRoller {
  Vec3 center, axis, normal;
  double half_face = 0.0;  ///< [m]
  double radius = 0.0;     ///< [m]
  double stiffness = 0.0;  ///< Normal penalty [N/m].
};

/// Closest point between centreline and roller axis.
struct ClosestPoint {
  bool found = false;  ///< False when the pipe does not pass the roller.
  int element = -1;
  int passing = -1;  ///< Element where the line passes the roller's axis; it may differ from `element` beyond the face.
  double xi = 0.0;
  Vec3 place = Vec3::Zero();      ///< Point of the centreline [m].
  Vec3 tangent = Vec3::Zero();    ///< Tangent of the centreline, derivative with the unstressed length.
  Vec3 reference = Vec3::Zero();  ///< Point of the axis that distance and projection refer to.
  bool beyond_face = false;
  double off_end = 0.0;  ///< Distance beyond the face, else 0 [m].
};

/// True if the pipe has left a roller's box sideways: it lies more than its own radius beyond the end of a bottom
/// roller, or on the wrong side of the roller after passing over that end.
inline bool has_left_box_sideways(RollerPosition position, const PlacedRoller& roller, const ClosestPoint& closest,
                                  double pipe_radius) {
  if (position != RollerPosition::bottom) return false;
  return closest.off_end > pipe_radius ||
         (closest.found && (closest.place - closest.reference).dot(roller.normal) < 0.0);
}

/// Returns the distance of the pipe's underside above the top of a bottom roller, along the roller's normal: negative
/// if the pipe lies next to it or below it, even far from its end [m].
inline double height_above_roller(const PlacedRoller& roller, const ClosestPoint& closest, double pipe_radius) {
  return (closest.place - closest.reference).dot(roller.normal) - roller.radius - pipe_radius;
}

/// Returns the closest point within elements [first, last) of the line; `q` six per node, `length` per element. The
/// element that contains the closest point is the one over which (r - C).t, projected, passes zero upwards, so that
/// each roller has one contact and each passage is counted once.
ClosestPoint closest_point(const PlacedRoller& roller, const double* q, const double* length, int first, int last);

/// Returns the closest point in a search outwards from the element and xi of its previous position.
ClosestPoint closest_point_near(const PlacedRoller& roller, const double* q, const double* length, int first, int last,
                                int element, double xi);

/// Finds closest points, distances and velocities for many rollers at once, each only in the element of its look.
/// `meetings` has at least one item per look.
void find_closest_points(const RolledLine& line, std::span<const RollerSearch> looks,
                         std::span<RollerClosestPoint> meetings, Isa isa);

/// Distance of centreline to axis at the closest point.
struct RollerDistance {
  double value = 0.0;             ///< Signed distance: negative on the wrong side [m].
  Vec3 direction = Vec3::Zero();  ///< Unit vector in which the roller pushes the pipe.
};
/// Returns the signed distance at a closest point.
RollerDistance roller_distance(const PlacedRoller& roller, const ClosestPoint& closest);

/// Gradient and Hessian of the distance in the element's unknowns with the closest point eliminated:
/// with f = |P(r - C)|^2 / 2, H(f) = N_i N_j P - f_xi,q f_xi,q' / f_xi,xi and H(d) = (H(f) - grad d grad d') / d.
struct RollerDistanceDerivatives {
  ElementVector gradient = ElementVector::Zero();
  ElementMatrix hessian = ElementMatrix::Zero();
  ElementVector place = ElementVector::Zero();  ///< Derivative of the closest point's position along the pipe [-], [m].
};
RollerDistanceDerivatives roller_distance_derivatives(const PlacedRoller& roller, const ClosestPoint& closest,
                                                      const RollerDistance& distance, const ElementVector& q,
                                                      double length);

}  // namespace overbend
