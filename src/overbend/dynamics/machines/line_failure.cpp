#include "dynamics/machines/line_failure.h"

#include <algorithm>

namespace overbend {
namespace {

constexpr double kSameTime = 1e-9;  ///< [s]

void release_end(Attachment& end) {
  end.hold_place = end.hold_direction = false;
  end.body = kGround;
}

}  // namespace

double time_to_line_failure(const System& system, const SystemState& state) {
  double min_time = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (!state.attachments[i].parted) min_time = std::min(min_time, system.attachments[i].parts_at - state.time);
  }
  return std::max(min_time, 0.0);
}

bool fail_due_lines(System& system, SystemState& state) {
  bool any = false;
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    AttachmentState& attachment = state.attachments[i];
    if (attachment.parted || system.attachments[i].parts_at > state.time + kSameTime) continue;
    attachment.parted = true;
    attachment.payout.rate = 0.0;
    release_end(system.attachments[i]);
    any = true;
  }
  return any;
}

void restore_failed_lines(const SystemState& state, System& system) {
  for (std::size_t i = 0; i < system.attachments.size(); ++i) {
    if (state.attachments[i].parted) release_end(system.attachments[i]);
  }
}

}  // namespace overbend
