#include "dynamics/run/hull_limits.h"

#include <fmt/format.h>

#include <cmath>

namespace overbend {
namespace {

const char* hinge_refusal(const HullState& at) {
  constexpr double kMost = 1.5707963267948966;
  return std::abs(at.h(kHingeFreedom)) < kMost ? nullptr : "more than 90 deg from where it is drawn; give it limits";
}

}  // namespace

std::optional<StaticFailure> hull_failure(const System& system, const SystemState& state) {
  std::size_t number = 0;
  for (const Body& body : system.bodies) {
    if (!body.free) continue;
    const HullState& at = state.bodies[number++];
    const bool hinged = body.free->hinge.has_value();
    if (const char* refusal = hinged ? hinge_refusal(at) : hull_refusal(at)) {
      return StaticFailure{hinged ? "the stinger turns further than it can on its hinge"
                                  : "the motion of the hull is beyond what its equations hold for",
                           fmt::format("at t = {:.2f} s", state.time), refusal};
    }
  }
  return std::nullopt;
}

}  // namespace overbend
