#include "dynamics/machines/tensioner_events.h"

#include <algorithm>
#include <limits>

namespace overbend {
namespace {

/// True if a tensioner starts and stops by its tension.
bool is_controlled(const Attachment& held) {
  return held.tensioner && held.tensioner->mode == TensionerMode::controlled;
}

}  // namespace

void observe_tensions(const Assembly& assembly, double h, SystemState& state) {
  for (std::size_t i = 0; i < assembly.tensioners().size(); ++i) {
    const std::size_t attachment = assembly.tensioners()[i].attachment;
    AttachmentState& held = state.attachments[attachment];
    const TensionerLaw& law = *assembly.system().attachments[attachment].tensioner;
    const Travel travel{held.travel.q, held.travel.v, held.travel.acc};
    const Travel after = observe(law, assembly.tension(i), h, travel, held.machine);
    if (after.length != travel.length || after.speed != travel.speed) {
      held.travel = {after.length, after.speed, after.acceleration, after.acceleration};
    }
  }
}

double time_to_tensioner(const System& system, const SystemState& state, double min_step) {
  double time = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (!is_controlled(system.attachments[i])) continue;
    time = std::min(time,
                    std::max(time_to_move(*system.attachments[i].tensioner, state.attachments[i].machine), min_step));
  }
  return time;
}

double step_to_tensioner(const Assembly& assembly, double h, const SystemState& from, const SystemState& to,
                         double min_step, std::vector<EventTry>& tried) {
  double step = h;
  for (std::size_t i = 0; i < assembly.tensioners().size(); ++i) {
    const std::size_t attachment = assembly.tensioners()[i].attachment;
    if (!is_controlled(assembly.system().attachments[attachment])) continue;
    const TensionerLaw& law = *assembly.system().attachments[attachment].tensioner;
    const AttachmentState &start = from.attachments[attachment], &next = to.attachments[attachment];
    const EventTry before =
        tried[i].h > 0.0 ? tried[i] : EventTry{0.0, excess(law, start.machine, start.machine.tension, start.travel.v)};
    tried[i] = {h, excess(law, next.machine, assembly.tension(i), next.travel.v)};
    step = std::min(step, step_to_event(law, before, tried[i], min_step));
  }
  return step;
}

}  // namespace overbend
