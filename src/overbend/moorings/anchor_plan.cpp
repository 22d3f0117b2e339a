#include "moorings/anchor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace overbend {
namespace {

constexpr int kNever = std::numeric_limits<int>::max();

double compute_azimuth(const Vec3& direction) {
  return std::atan2(direction.x(), direction.y());
}

/// Line along the route with its anchor at its current position.
struct LineOnRoute {
  MooredLine line;
  LineUsefulRange useful;
  Vec3 fairlead_W, anchor_W;  ///< Before the first joint; the anchor at its nominal position.
  double azimuth = 0.0;       ///< Nominal azimuth [rad].
};

class Planner {
 public:
  Planner(const MooringSpread& spread, const Mat3& drawn, const std::vector<LineUsefulRange>& useful,
          const AnchorRoute& route)
      : spread_(spread), route_(route) {
    for (std::size_t i = 0; i < spread.lines.size(); ++i) {
      const MooredLine& line = spread.lines[i];
      const Vec3 fairlead = drawn * line.fairlead_V;
      lines_.push_back(
          {line, useful[i], fairlead, line.anchor_W, compute_azimuth(line_direction(line, fairlead).direction_W)});
    }
  }

  AnchorSchedule plan() {
    AnchorSchedule schedule;
    for (const LineOnRoute& moored : lines_) {
      if (moored.useful.range.given() && !is_in_range(moored, 0)) {
        schedule.error =
            fmt::format("mooring line \"{}\" is outside its useful range in the nominal position", moored.line.name);
        return schedule;
      }
      last_useful_.push_back(last_joint(moored, 0));
    }
    for (int joint = 1; joint <= route_.joints; ++joint) {
      const std::optional<std::size_t> due = line_due(joint - 1);
      if (!due) continue;
      std::optional<AnchorMove> shift = move(*due, joint);
      if (!shift) {
        schedule.error = fmt::format(
            "mooring line \"{}\" leaves its useful range after joint {}: no anchor position ahead of the nominal one "
            "is in range, or more than one anchor would have to be moved at a time",
            lines_[*due].line.name, joint);
        return schedule;
      }
      schedule.shifts.push_back(*shift);
    }
    return schedule;
  }

 private:
  Vec3 displacement(int joints) const { return static_cast<double>(joints) * route_.step_W; }

  bool is_in_range(const LineOnRoute& moored, int joints) const {
    double length = 0.0;
    return find_exceeded_bound(spread_, moored.line, moored.useful, moored.azimuth,
                               moored.fairlead_W + displacement(joints), length) == nullptr;
  }

  /// Returns the last number of laid joints at which a line is still in its range, starting from one at which it is.
  int last_joint(const LineOnRoute& moored, int from) const {
    if (!moored.useful.range.given()) return kNever;
    for (int joints = from + 1; joints <= route_.joints; ++joints) {
      if (!is_in_range(moored, joints)) return joints - 1;
    }
    return kNever;
  }

  /// Returns the line whose anchor has to be moved with `laid` joints laid. One anchor per joint, the line that leaves
  /// its range first, and only if waiting would make another move late.
  std::optional<std::size_t> line_due(int laid) const {
    std::vector<std::size_t> order(lines_.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return last_useful_[a] < last_useful_[b]; });
    int latest = kNever;
    for (std::size_t k = 0; k < order.size() && last_useful_[order[k]] != kNever; ++k) {
      latest = std::min(latest, last_useful_[order[k]] - static_cast<int>(k));
    }
    return laid >= latest ? std::optional(order.front()) : std::nullopt;
  }

  /// Moves the anchor as far ahead of its nominal position as the range allows; nullopt if that is not ahead of its
  /// present position.
  std::optional<AnchorMove> move(std::size_t index, int joint) {
    LineOnRoute& moored = lines_[index];
    const int laid = joint - 1;
    LineOnRoute moved = moored;
    const auto place = [&](int ahead) {
      moved.line.anchor_W = moored.anchor_W + displacement(ahead);
      moved.line.anchor_W.z() = spread_.bed.height(moved.line.anchor_W.x(), moved.line.anchor_W.y());
    };
    int ahead = laid;  // nominal position
    for (place(ahead + 1); is_in_range(moved, laid) && ahead < laid + route_.joints; place(ahead + 1)) ++ahead;
    place(ahead);
    const int until = last_joint(moved, laid);
    if (!is_in_range(moved, laid) || until <= last_useful_[index]) return std::nullopt;
    AnchorMove shift{joint, index, moored.line.anchor_W, moved.line.anchor_W, 0.0, ""};
    if (const char* bound =
            find_exceeded_bound(spread_, moored.line, moored.useful, moored.azimuth,
                                moored.fairlead_W + displacement(last_useful_[index] + 1), shift.length)) {
      shift.reason = bound;
    }
    find_exceeded_bound(spread_, moved.line, moored.useful, moored.azimuth, moored.fairlead_W + displacement(laid),
                        shift.length);
    moored.line = moved.line;
    last_useful_[index] = until;
    return shift;
  }

  const MooringSpread& spread_;
  AnchorRoute route_;
  std::vector<LineOnRoute> lines_;
  std::vector<int> last_useful_;
};

}  // namespace

const char* find_exceeded_bound(const MooringSpread& spread, const MooredLine& line, const LineUsefulRange& useful,
                                double drawn_azimuth, const Vec3& fairlead_W, double& length) {
  const LineDirection to = line_direction(line, fairlead_W);
  CatenaryLine found = line.line;
  const CatenarySolution solution =
      set_length_for_pull(found, line_site(spread, line, fairlead_W), to.distance, useful.pull);
  if (solution.error != CatenaryError::none) return "no length gives its pull";
  length = found.length();
  const double off = std::abs(std::remainder(compute_azimuth(to.direction_W) - drawn_azimuth, 2.0 * std::numbers::pi));
  if (useful.range.min_length && length < *useful.range.min_length) return "least length";
  if (useful.range.max_length && length > *useful.range.max_length) return "most length";
  if (useful.range.sector && off > *useful.range.sector) return "sector";
  return nullptr;
}

AnchorSchedule plan_anchors(const MooringSpread& spread, const Mat3& drawn, const std::vector<LineUsefulRange>& useful,
                            const AnchorRoute& route) {
  return Planner(spread, drawn, useful, route).plan();
}

}  // namespace overbend
