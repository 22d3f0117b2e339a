/// First guess of the S: over the supports, then a catenary down to the seabed.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/lay_route.h"
#include "model/model.h"

namespace overbend {

/// The vertical plane in which the barge lays, and the frame of the laid tail.
struct LayPlane {
  LayRoute route;          ///< From the tensioner on.
  Vec3 tensioner_W;        ///< Pipe axis at the tensioner [m].
  Vec3 astern_W;           ///< Horizontal unit vector.
  Vec3 port_W;             ///< Horizontal unit vector to port.
  BedSurface surface;      ///< Of the sea bed.
  double radius = 0.0;     ///< Of the pipe that lies on it [m].
  double guide_dip = 0.0;  ///< Inclination of the guide from horizontal, positive dipping astern [rad].

  /// Height of the pipe's axis where it rests on the bed, at a distance along the route [m].
  double bed(double distance) const;
  /// Rise of the bed per metre along the route [-].
  double bed_slope(double distance) const;
};

LayPlane lay_plane(const Model& model, const VesselPose& pose);

/// What is wrong with a line, where, and why.
struct ShapeFault {
  std::string what, where, why;
};

/// A curve in the lay plane: dense points by unstressed length from the tensioner.
struct LayShape {
  std::vector<double> length;       ///< From the tensioner [m].
  std::vector<double> distance;     ///< Horizontal, astern of the tensioner [m].
  std::vector<double> z;            ///< [m]
  std::vector<double> dip;          ///< Inclination, positive dipping astern [rad].
  double last_support = 0.0;        ///< Length to the end of the supports used [m].
  double touchdown = 0.0;           ///< Length to touchdown [m].
  double waterline = -1.0;          ///< Length to the water surface [m].
  double total = 0.0;               ///< Length to the anchor [m].
  double bottom_tension = 0.0;      ///< Horizontal tension of the guess [N].
  std::optional<double> far_force;  ///< Horizontal tension at the far end, where it is another one [N].
  std::vector<double> edges;        ///< Of a dragged line: lengths where contact with the bed begins or ends [m].
  std::optional<ShapeFault> fault;  ///< Of a dragged line: why there is none, or why there may be no equilibrium.
  std::string problem;              ///< Why there is no such curve; empty when there is.
};

/// Work of the pipe's weight per length between the bed and the tensioner: what the tension loses on the way down. A
/// frictionless rod keeps N + EI kappa^2/2 + (weight of the pipe hanging below), so tension - this is the bottom
/// tension but for bending. Where the line has several sections, of the lightest: nothing is refused that may hang.
double hanging_weight(const Model& model, const LayPlane& plane, double bed_z);

/// The same of a line that is of this section from end to end.
double hanging_weight(const Model& model, const LayPlane& plane, const Section& section, double bed_z);

/// Where a first guess lands on a bed that is not level: the depth at touchdown follows from the shape.
class LandingSearch {
 public:
  explicit LandingSearch(const LayPlane& plane) : plane_(&plane) {}

  /// Distance astern of the tensioner for whose depth the next shape is made [m].
  double at() const { return at_; }
  /// Takes where that shape landed [m]; false where the bed is as deep there, to `near` [m].
  bool follow(double landed, double near);

 private:
  const LayPlane* plane_;
  double at_ = 0.0;
  double nearest_ = 0.0, farthest_ = std::numeric_limits<double>::infinity();  ///< It lands in between.
};

/// How often a shape is made for another landing.
inline constexpr int kLandings = 16;

/// `tension` at the tensioner [N]; `bottom_tension` > 0 overrides the one that follows from it (continuation).
LayShape lay_shape(const Model& model, const LayPlane& plane, double tension);

}  // namespace overbend
