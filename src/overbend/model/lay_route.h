/// The line on which the pipe is laid, in plan: place, direction and curvature as functions of the distance s along it
/// behind the tensioner. Today it is straight.
#pragma once

#include "base/vec.h"
#include "model/model.h"

namespace overbend {

class LayRoute {
 public:
  /// Straight from `start_W`, where s = 0, towards the horizontal unit vector `astern_W`.
  LayRoute(const Vec3& start_W, const Vec3& astern_W);

  /// At the height of the start [m].
  Vec3 place(double s) const { return start_W_ + s * astern_W_; }
  /// Horizontal unit vector away from the barge.
  const Vec3& direction(double /*s*/) const { return astern_W_; }
  /// Horizontal unit vector across the route, to the barge's port.
  const Vec3& port(double /*s*/) const { return port_W_; }
  /// Of the route in plan, positive where it turns to port with s [1/m].
  double curvature(double /*s*/) const { return 0.0; }
  /// s of the point of the route that is nearest in plan [m].
  double distance(const Vec3& p_W) const { return (p_W - start_W_).dot(astern_W_); }
  /// Distance in plan from there, to port [m].
  double offset(const Vec3& p_W) const { return port_W_.dot(p_W) - port_offset_; }

  /// port . point of the route, for kernels, which compute `offset` themselves [m].
  double port_offset() const { return port_offset_; }

 private:
  Vec3 start_W_, astern_W_, port_W_;
  double port_offset_ = 0.0;
};

/// The route of the barge as described: from the pipe's axis at the tensioner, straight astern. A barge that its
/// moorings let drift does not take it along.
LayRoute lay_route(const Model& model);

}  // namespace overbend
