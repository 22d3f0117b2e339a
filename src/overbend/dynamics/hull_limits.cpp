#include "dynamics/hull_limits.h"

#include <fmt/format.h>

namespace overbend {

std::optional<StaticFailure> hull_failure(const System& system, const SystemState& state) {
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    if (!system.bodies[i].free) continue;
    if (const char* refusal = hull_refusal(state.bodies[i])) {
      return StaticFailure{"the motion of the hull is beyond what its equations hold for",
                           fmt::format("at t = {:.2f} s", state.time), refusal};
    }
  }
  return std::nullopt;
}

}  // namespace overbend
