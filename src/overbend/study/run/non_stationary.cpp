#include "study/run/non_stationary.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/shown_unit.h"

namespace overbend {
namespace {

constexpr double kFelt = 0.01;  ///< Length that an end gives way by, as it is warned of [m].

/// Of one line; empty where nothing happened to it.
std::string happened_to(const MooringLineDynamics& line) {
  if (line.parted_at) return fmt::format("mooring line \"{}\" parted at t = {:.1f} s", line.name, *line.parted_at);
  if (line.anchor_slip > kFelt) {
    return fmt::format("the anchor of mooring line \"{}\" dragged by {}", line.name, shown(line.anchor_slip, "m", 2));
  }
  if (line.brake_rendered > kFelt) {
    return fmt::format("the brake of mooring line \"{}\" paid out {}", line.name, shown(line.brake_rendered, "m", 2));
  }
  return {};
}

/// Whether a winch follows a program while statistics count.
bool is_moved(const WinchDescription& winch, double duration) {
  return std::ranges::any_of(winch.program,
                             [&](const WinchStepDescription& step) { return step.time > 0.0 && step.time < duration; });
}

std::string moved_winch(const Description& description, double duration) {
  if (!description.moorings) return {};
  const auto& winches = description.moorings->winches;
  const auto moved =
      std::ranges::find_if(winches, [&](const WinchDescription& winch) { return is_moved(winch, duration); });
  return moved == winches.end() ? std::string() : fmt::format("winch \"{}\" follows its program", moved->name);
}

bool is_let_go(const VesselDescription& vessel) {
  return vessel.coupled && !(vessel.coupled->released_shift.isZero() && vessel.coupled->released_turn.isZero());
}

}  // namespace

std::string non_stationary(const Description& description, const DynamicResults& results) {
  for (const MooringLineDynamics& line : results.moorings) {
    if (std::string what = happened_to(line); !what.empty()) return what;
  }
  if (std::string what = moved_winch(description, results.duration); !what.empty()) return what;
  if (description.operation.type == OperationType::pull_ahead) return "the vessel is pulled ahead";
  return is_let_go(description.vessel) ? "the hull is let go from an offset" : std::string();
}

}  // namespace overbend
