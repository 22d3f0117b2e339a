#include "dynamics/machines/parting.h"

#include <algorithm>

namespace overbend {
namespace {

constexpr double kSameTime = 1e-9;  ///< [s]

void let_go(Attachment& end) {
  end.hold_place = end.hold_direction = false;
  end.body = kGround;
}

}  // namespace

double time_to_parting(const System& system, const SystemState& state) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (!state.attachments[i].parted) least = std::min(least, system.attachments[i].parts_at - state.time);
  }
  return std::max(least, 0.0);
}

bool part_due_lines(System& system, SystemState& state) {
  bool any = false;
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    AttachmentState& at = state.attachments[i];
    if (at.parted || system.attachments[i].parts_at > state.time + kSameTime) continue;
    at.parted = true;
    at.way.rate = 0.0;
    let_go(system.attachments[i]);
    any = true;
  }
  return any;
}

void part_as_in(const SystemState& state, System& system) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (state.attachments[i].parted) let_go(system.attachments[i]);
  }
}

}  // namespace overbend
