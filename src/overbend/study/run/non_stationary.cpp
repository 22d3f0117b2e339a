#include "study/run/non_stationary.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

constexpr double kMinReportedSlip = 0.01;  ///< Anchor drag or rendered length from which it is reported [m].

/// Returns the event of one line; empty if there is none.
std::string find_line_event(const MooringLineDynamics& line) {
  if (line.parted_at) return fmt::format("mooring line \"{}\" parted at t = {:.1f} s", line.name, *line.parted_at);
  if (line.anchor_slip > kMinReportedSlip) {
    return fmt::format("the anchor of mooring line \"{}\" dragged by {}", line.name, shown(line.anchor_slip, "m", 2));
  }
  if (line.brake_rendered > kMinReportedSlip) {
    return fmt::format("the brake of mooring line \"{}\" paid out {}", line.name, shown(line.brake_rendered, "m", 2));
  }
  return {};
}

/// True if a winch follows a program after t = 0.
bool is_moved(const WinchDescription& winch, double duration) {
  return ranges::any_of(winch.program,
                        [&](const WinchStepDescription& step) { return step.time > 0.0 && step.time < duration; });
}

std::string find_moved_winch(const Description& description, double duration) {
  if (!description.moorings) return {};
  const auto& winches = description.moorings->winches;
  const auto moved = ranges::find_if(winches, [&](const WinchDescription& winch) { return is_moved(winch, duration); });
  return moved == winches.end() ? std::string() : fmt::format("winch \"{}\" follows its program", moved->name);
}

bool is_released(const VesselDescription& vessel) {
  return vessel.coupled && !(vessel.coupled->release_offset.isZero() && vessel.coupled->release_rotation.isZero());
}

}  // namespace

std::string non_stationary(const Description& description, const DynamicResults& results) {
  for (const MooringLineDynamics& line : results.moorings) {
    if (std::string what = find_line_event(line); !what.empty()) return what;
  }
  if (std::string what = find_moved_winch(description, results.duration); !what.empty()) return what;
  if (description.operation.type == OperationType::pull_ahead) return "the vessel is pulled ahead";
  return is_released(description.vessel) ? "the hull is released from an offset" : std::string();
}

}  // namespace overbend
