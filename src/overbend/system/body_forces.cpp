#include "system/body_forces.h"

#include "system/held_end.h"

namespace overbend {
namespace {

void add(const Vec3& force, const Vec3& arm, ForceAndMoment& sum) {
  sum.force += force;
  sum.moment += arm.cross(force);
}

}  // namespace

ForceAndMoment force_on_body(const Assembly& assembly, const SystemState& state, int body) {
  const System& system = assembly.system();
  const Vec3 origin = assembly.surroundings().bodies[static_cast<std::size_t>(body)].pose.p_WV;
  ForceAndMoment sum;
  for (const Attachment& held : system.attachments) {
    if (held.body != body) continue;
    const auto line = static_cast<std::size_t>(held.line);
    const auto node = static_cast<std::size_t>(held_node(held, system.lines[line]));
    const double* by_body = assembly.line(line).held_force(static_cast<int>(node)).data();
    const double* q = state.lines[line].q.data() + 6 * node;
    add(-Eigen::Map<const Vec3>(by_body), Eigen::Map<const Vec3>(q) - origin, sum);
    if (held.hold_direction) sum.moment -= Eigen::Map<const Vec3>(q + 3).cross(Eigen::Map<const Vec3>(by_body + 3));
  }
  for (std::size_t i = 0; i < system.wires.size(); ++i) {
    const WirePull& pull = assembly.wires()[i];
    if (system.wires[i].first_body == body) add(pull.force, pull.first - origin, sum);
    if (system.wires[i].second_body == body) add(-pull.force, pull.second - origin, sum);
  }
  return sum;
}

}  // namespace overbend
