#include "model/lay_route.h"

namespace overbend {

LayRoute::LayRoute(const Vec3& start_W, const Vec3& astern_W)
    : start_W_(start_W),
      astern_W_(astern_W),
      port_W_(astern_W.cross(Vec3::UnitZ())),
      port_offset_(port_W_.dot(start_W)) {}

LayRoute lay_route(const Model& model) {
  const TensionerDescription& tensioner = model.description.tensioner;
  return {point_from_ramp(model, model.drawn_pose, Vec3(tensioner.x, 0.0, tensioner.z)),
          astern_direction(model.drawn_pose)};
}

}  // namespace overbend
