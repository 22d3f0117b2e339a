#include "statics/moored/vessel_load.h"

namespace overbend {

Vec6 load_on_vessel(StaticSystem& system, const LineState& state) {
  system.evaluate(state, false);
  Vec6 load = Vec6::Zero();
  const auto add = [&](const Vec3& force, const Vec3& arm) {
    load.head<3>() += force;
    load.tail<3>() += arm.cross(force);
  };
  const Vec3& origin = system.pose().p_WV;
  for (const RollerContact& contact : system.contacts()) {
    if (contact.normal > 0.0) {
      add(-contact.force(), contact.closest.place - origin);
    }
  }
  for (std::size_t i = 0; i < system.line().wires.size(); ++i) {
    const WirePull& pull = system.wire_pulls()[i];
    if (system.line().wires[i].wire.first_body != kGround) add(pull.force, pull.first - origin);
  }
  const int top = system.mesh().nodes() - 1;
  const double* node = state.q.data() + 6 * top;
  add(-system.end_reaction(top), Vec3(Eigen::Map<const Vec3>(node)) - origin);
  // The residual of the last node's tangent is a moment on the guide.
  const Vec3 turning(Eigen::Map<const Vec3>(system.residual().data() + 6 * top + 3));
  load.tail<3>() -= Vec3(Eigen::Map<const Vec3>(node + 3)).cross(turning);
  return load;
}

}  // namespace overbend
