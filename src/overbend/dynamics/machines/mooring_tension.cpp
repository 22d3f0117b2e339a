#include "dynamics/machines/mooring_tension.h"

namespace overbend {

bool moored_quasi_statically(const Assembly& assembly) {
  return assembly.free_bodies() > 0 && !assembly.free_body(0).springs.empty();
}

double mooring_tension(const Assembly& assembly, const SystemState& state, std::size_t mooring, LineEnd end) {
  if (moored_quasi_statically(assembly)) {
    const LineEndForces& line = state.bodies.front().lines[mooring];
    return end == LineEnd::last ? line.fairlead_tension() : line.anchor_tension();
  }
  const std::size_t first = first_line(assembly.system(), LineRole::mooring);
  const std::array<double, 6>& force = assembly.line(first + mooring).end_force(end);
  return Vec3(force[0], force[1], force[2]).norm();
}

}  // namespace overbend
