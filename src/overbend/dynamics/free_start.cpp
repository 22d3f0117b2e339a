#include "dynamics/free_start.h"

#include "statics/rest_together.h"

namespace overbend {

std::optional<StaticFailure> rest_afloat(Assembly& assembly, Ballast ballast, Hull& hull, SystemState& state) {
  const System& system = assembly.system();
  const bool locked = tensioner_of(system).mode == TensionerMode::locked;
  assembly.set_time(state.time, state);
  assembly.set_drive(locked ? TensionerDrive::brake : TensionerDrive::governor);
  assembly.impose_ends(state);
  if (ballast == Ballast::trim) {
    SystemState held = state;
    assembly.evaluate(held, state, {}, false);
    for (Eigen::Index freedom = 2; freedom < 5; ++freedom) {  // heave, roll, pitch
      hull.ballast(freedom) += assembly.body_residual()[static_cast<std::size_t>(freedom)];
    }
  }
  const RestReport report = rest_together(assembly, state);
  for (HullState& body : state.bodies) {
    body.slow = slow_rest(body.h);
  }
  if (report.converged) {
    return std::nullopt;
  }
  return StaticFailure{"hull and lines do not come to rest together",
                       report.worst_place.first == kBodyPlace ? "the forces on the hull do not balance"
                                                              : "the forces on a line do not balance",
                       "look whether anything holds the hull in surge, sway and yaw"};
}

}  // namespace overbend
