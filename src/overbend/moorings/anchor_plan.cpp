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

double azimuth_of(const Vec3& direction) {
  return std::atan2(direction.x(), direction.y());
}

/// One line along the route, its anchor where it lies now.
struct Moored {
  MooredLine line;
  UsefulLine useful;
  Vec3 fairlead_W, anchor_W;  ///< Before the first joint; the anchor as drawn.
  double azimuth = 0.0;       ///< As drawn.
};

class Planner {
 public:
  Planner(const MooringSpread& spread, const Mat3& drawn, const std::vector<UsefulLine>& useful,
          const AnchorRoute& route)
      : spread_(spread), route_(route) {
    for (std::size_t i = 0; i < spread.lines.size(); ++i) {
      const MooredLine& line = spread.lines[i];
      const Vec3 fairlead = drawn * line.fairlead_V;
      lines_.push_back(
          {line, useful[i], fairlead, line.anchor_W, azimuth_of(line_direction(line, fairlead).direction_W)});
    }
  }

  AnchorSchedule plan() {
    AnchorSchedule schedule;
    for (const Moored& at : lines_) {
      if (at.useful.range.given() && !serves(at, 0)) {
        schedule.fault = fmt::format("mooring line \"{}\" is not in its useful range as drawn", at.line.name);
        return schedule;
      }
      last_useful_.push_back(last_joint(at, 0));
    }
    for (int joint = 1; joint <= route_.joints; ++joint) {
      const std::optional<std::size_t> due = line_due(joint - 1);
      if (!due) continue;
      std::optional<AnchorShift> shift = move(*due, joint);
      if (!shift) {
        schedule.fault = fmt::format(
            "mooring line \"{}\" cannot be of use beyond joint {}: no place of its anchor ahead of the drawn one "
            "serves, "
            "or more anchors are due at a time than one",
            lines_[*due].line.name, joint);
        return schedule;
      }
      schedule.shifts.push_back(*shift);
    }
    return schedule;
  }

 private:
  Vec3 way(int joints) const { return static_cast<double>(joints) * route_.step_W; }

  bool serves(const Moored& at, int joints) const {
    double length = 0.0;
    return useless(spread_, at.line, at.useful, at.azimuth, at.fairlead_W + way(joints), length) == nullptr;
  }

  /// The last number of joints laid at which a line still serves, from one at which it does.
  int last_joint(const Moored& at, int from) const {
    if (!at.useful.range.given()) return kNever;
    for (int joints = from + 1; joints <= route_.joints; ++joints) {
      if (!serves(at, joints)) return joints - 1;
    }
    return kNever;
  }

  /// The line whose anchor has to be moved now, with so many joints laid: at most one each, the one that leaves first,
  /// where waiting would make one of them late.
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

  /// Farthest ahead of where it was drawn that still serves now; nothing where that is no farther than it is.
  std::optional<AnchorShift> move(std::size_t index, int joint) {
    Moored& at = lines_[index];
    const int laid = joint - 1;
    Moored there = at;
    const auto place = [&](int ahead) {
      there.line.anchor_W = at.anchor_W + way(ahead);
      there.line.anchor_W.z() = spread_.bed.height(there.line.anchor_W.x(), there.line.anchor_W.y());
    };
    int ahead = laid;  // as drawn
    for (place(ahead + 1); serves(there, laid) && ahead < laid + route_.joints; place(ahead + 1)) ++ahead;
    place(ahead);
    const int until = last_joint(there, laid);
    if (!serves(there, laid) || until <= last_useful_[index]) return std::nullopt;
    AnchorShift shift{joint, index, at.line.anchor_W, there.line.anchor_W, 0.0, ""};
    if (const char* bound = useless(spread_, at.line, at.useful, at.azimuth,
                                    at.fairlead_W + way(last_useful_[index] + 1), shift.length)) {
      shift.reason = bound;
    }
    useless(spread_, there.line, at.useful, at.azimuth, at.fairlead_W + way(laid), shift.length);
    at.line = there.line;
    last_useful_[index] = until;
    return shift;
  }

  const MooringSpread& spread_;
  AnchorRoute route_;
  std::vector<Moored> lines_;
  std::vector<int> last_useful_;
};

}  // namespace

const char* useless(const MooringSpread& spread, const MooredLine& line, const UsefulLine& useful, double drawn_azimuth,
                    const Vec3& fairlead_W, double& length) {
  const LineDirection to = line_direction(line, fairlead_W);
  CatenaryLine found = line.line;
  const CatenarySolution solution =
      set_length_for_pull(found, line_site(spread, line, fairlead_W), to.distance, useful.pull);
  if (solution.fault != CatenaryFault::none) return "no length gives its pull";
  length = found.length();
  const double off = std::abs(std::remainder(azimuth_of(to.direction_W) - drawn_azimuth, 2.0 * std::numbers::pi));
  if (useful.range.least_length && length < *useful.range.least_length) return "least length";
  if (useful.range.most_length && length > *useful.range.most_length) return "most length";
  if (useful.range.sector && off > *useful.range.sector) return "sector";
  return nullptr;
}

AnchorSchedule plan_anchors(const MooringSpread& spread, const Mat3& drawn, const std::vector<UsefulLine>& useful,
                            const AnchorRoute& route) {
  return Planner(spread, drawn, useful, route).plan();
}

}  // namespace overbend
