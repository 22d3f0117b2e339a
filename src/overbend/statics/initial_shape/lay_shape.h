/// Initial shape of an S-lay: over the supports, then a catenary down to the seabed.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "model/lay_route.h"
#include "model/model.h"

namespace overbend {

/// Vertical plane of the lay and frame of the laid pipe.
struct LayPlane {
  LayRoute route;          ///< Starts at the tensioner.
  Vec3 tensioner_W;        ///< Pipe axis at the tensioner [m].
  Vec3 astern_W;           ///< Horizontal unit vector.
  Vec3 port_W;             ///< Horizontal unit vector to port.
  SeabedSurface surface;   ///< Seabed.
  double radius = 0.0;     ///< Radius of the pipe on the bed [m].
  double guide_dip = 0.0;  ///< Inclination of the guide from horizontal, positive dipping astern [rad].

  /// Height of the axis of a pipe on the bed, at a distance along the route [m].
  double bed(double distance) const;
  /// Slope of the bed along the route, positive where it rises [-].
  double bed_slope(double distance) const;
};

/// Returns the lay plane of a model at a vessel pose.
LayPlane lay_plane(const Model& model, const VesselPose& pose);

/// Error of a line: what is wrong, where, and why.
struct ShapeError {
  std::string what, where, why;
};

/// Curve in the lay plane: dense points by unstressed length from the tensioner.
struct LayShape {
  std::vector<double> length;       ///< From the tensioner [m].
  std::vector<double> distance;     ///< Horizontal, astern of the tensioner [m].
  std::vector<double> z;            ///< [m]
  std::vector<double> dip;          ///< Inclination, positive dipping astern [rad].
  double last_support = 0.0;        ///< Length to the end of the supports used [m].
  double touchdown = 0.0;           ///< Length to touchdown [m].
  double waterline = -1.0;          ///< Length to the water surface [m].
  double total = 0.0;               ///< Length to the anchor [m].
  double bottom_tension = 0.0;      ///< Horizontal tension at touchdown in the initial shape [N].
  std::optional<double> far_force;  ///< Horizontal tension at the far end, if different [N].
  std::vector<double> edges;        ///< Lengths at which contact of a dragged line with the bed begins or ends [m].
  std::optional<ShapeError> error;  ///< Reason why a dragged line has no shape, or may have no equilibrium.
  std::string problem;              ///< Reason why there is no such curve; empty if there is one.
};

/// Work of the pipe's weight per length between the bed and the tensioner: the loss of tension on the way down [N]. A
/// frictionless rod keeps N + EI kappa^2/2 + (weight of the pipe suspended below) constant, so tension minus this is
/// the bottom tension except for bending. For a line with several sections that of the lightest, so that no feasible
/// line is rejected.
double suspended_pipe_weight(const Model& model, const LayPlane& plane, double bed_z);

/// Same for a line with this section over its whole length.
double suspended_pipe_weight(const Model& model, const LayPlane& plane, const Section& section, double bed_z);

/// Search for the landing of an initial shape on a bed that is not level: the depth at touchdown depends on the shape.
class LandingSearch {
 public:
  explicit LandingSearch(const LayPlane& plane) : plane_(&plane) {}

  /// Distance astern of the tensioner whose depth the next shape uses [m].
  double assumed_distance() const { return assumed_distance_; }
  /// Takes the landing of that shape [m]; returns false if the bed has the same depth there, to `near` [m].
  bool accept_landing(double landed, double near);

 private:
  const LayPlane* plane_;
  double assumed_distance_ = 0.0;
  double nearest_ = 0.0, farthest_ = std::numeric_limits<double>::infinity();  ///< Bounds of the landing.
};

/// Maximum number of shapes computed for the landing.
inline constexpr int kMaxLandings = 16;

/// `tension`: at the tensioner [N].
LayShape lay_shape(const Model& model, const LayPlane& plane, double tension);

}  // namespace overbend
