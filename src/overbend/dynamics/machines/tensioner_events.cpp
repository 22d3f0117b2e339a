#include "dynamics/machines/tensioner_events.h"

#include <algorithm>
#include <limits>

namespace overbend {
namespace {

/// Whether a tensioner starts and stops by its tension.
bool controlled(const System& system) {
  return system.machine >= 0 && tensioner_of(system).mode == TensionerMode::controlled;
}

const AttachmentState& held_at(const System& system, const SystemState& state) {
  return state.attachments[static_cast<std::size_t>(system.machine)];
}

}  // namespace

void observe_tension(const Assembly& assembly, double h, SystemState& state) {
  const System& system = assembly.system();
  if (system.machine < 0) return;
  AttachmentState& held = state.attachments[static_cast<std::size_t>(system.machine)];
  const Travel travel{held.travel.q, held.travel.v, held.travel.acc};
  const Travel after = observe(tensioner_of(system), assembly.machine_tension(), h, travel, held.machine);
  if (after.length != travel.length || after.speed != travel.speed) {
    held.travel = {after.length, after.speed, after.acceleration, after.acceleration};
  }
}

double time_to_tensioner(const System& system, const SystemState& state, double least) {
  if (!controlled(system)) return std::numeric_limits<double>::infinity();
  return std::max(time_to_move(tensioner_of(system), held_at(system, state).machine), least);
}

double step_to_tensioner(const Assembly& assembly, double h, const SystemState& from, const SystemState& to,
                         double least, EventTry& tried) {
  const System& system = assembly.system();
  if (!controlled(system)) return h;
  const TensionerLaw& law = tensioner_of(system);
  const AttachmentState &now = held_at(system, from), &next = held_at(system, to);
  const EventTry before =
      tried.h > 0.0 ? tried : EventTry{0.0, excess(law, now.machine, now.machine.tension, now.travel.v)};
  tried = {h, excess(law, next.machine, assembly.machine_tension(), next.travel.v)};
  return step_to_event(law, before, tried, least);
}

}  // namespace overbend
