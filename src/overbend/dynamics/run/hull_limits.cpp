#include "dynamics/run/hull_limits.h"

#include <fmt/format.h>

#include <cmath>

namespace overbend {
namespace {

const char* hinge_limit_message(const HullState& state) {
  constexpr double kMaxAngle = 1.5707963267948966;
  return std::abs(state.h(kHingeFreedom)) < kMaxAngle ? nullptr
                                                      : "more than 90 deg from its nominal position; give it limits";
}

}  // namespace

std::optional<StaticFailure> hull_failure(const System& system, const SystemState& state) {
  std::size_t number = 0;
  for (const Body& body : system.bodies) {
    if (!body.free) continue;
    const HullState& body_state = state.bodies[number++];
    const bool hinged = body.free->hinge.has_value();
    if (const char* message = hinged ? hinge_limit_message(body_state) : hull_limit_message(body_state)) {
      return StaticFailure{
          hinged ? "the stinger rotates too far on its hinge" : "the hull motion exceeds the validity of its equations",
          fmt::format("at t = {:.2f} s", state.time), message};
    }
  }
  return std::nullopt;
}

}  // namespace overbend
