#include "moorings/mooring_spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

/// Step of finite differences over a sloping bed [m].
constexpr double kDifference = 1e-3;

Vec3 chart_direction(double azimuth) {
  return {std::sin(azimuth), std::cos(azimuth), 0.0};
}

Vec3 anchor_place(const MooringLineDescription& line, const SeabedSurface& bed, const Mat3& drawn) {
  Vec3 anchor = Vec3::Zero();
  if (line.anchor) {
    anchor = {(*line.anchor)[0], (*line.anchor)[1], 0.0};
  } else {
    const Vec3 forward = drawn.col(0);
    const double bow = std::atan2(forward.x(), forward.y());
    const double azimuth = line.azimuth.value_or(bow + line.bearing.value_or(0.0));
    anchor = drawn * line.fairlead + line.anchor_distance.value_or(0.0) * chart_direction(azimuth);
  }
  anchor.z() = bed.height(anchor.x(), anchor.y());
  return anchor;
}

std::optional<double> min_breaking_load(const MooringLineDescription& line) {
  std::optional<double> min_load;
  for (const LineSegmentDescription& segment : line.segments) {
    const std::optional<double>& load = segment.type.breaking_load;
    if (load) min_load = std::min(*load, min_load.value_or(*load));
  }
  return min_load;
}

MooredLine moored_line(const MooringsDescription& moorings, const MooringLineDescription& from,
                       const SeabedSurface& bed, const Mat3& drawn) {
  MooredLine line;
  line.name = from.name;
  line.fairlead_V = from.fairlead;
  line.anchor_W = anchor_place(from, bed, drawn);
  line.line = catenary_line(from.segments, from.points, moorings.bed_friction.value_or(0.0), kGravity);
  line.breaking_load = min_breaking_load(from);
  line.holding = from.anchor_holding.holding;
  const auto winch = std::find_if(moorings.winches.begin(), moorings.winches.end(),
                                  [&](const WinchDescription& candidate) { return candidate.name == from.winch; });
  if (winch != moorings.winches.end()) line.drum = winch->drum;
  return line;
}

MooringError set_drawn_length(const MooringSpread& spread, MooredLine& line, double tension, const Mat3& drawn) {
  const Vec3 fairlead = drawn * line.fairlead_V;
  const CatenarySite site = line_site(spread, line, fairlead);
  const double distance = line_direction(line, fairlead).distance;
  const CatenarySolution solution = set_length_for_tension(line.line, site, distance, tension);
  if (solution.error == CatenaryError::none) return std::nullopt;
  if (solution.error == CatenaryError::below_bed) return line_error_message(spread, line, fairlead, solution.error);
  return fmt::format("mooring line \"{}\": no length of its first segment gives a tension of {} with the anchor at {}",
                     line.name, shown(tension, "N", 1), shown(distance, "m", 1));
}

Mat3 straight_bed_stiffness(const CatenarySolution& solution, const LineDirection& to) {
  const Eigen::Matrix2d& k = solution.stiffness;  // of (pull, sink) by (distance, height)
  const Vec3 &d = to.direction_W, up = Vec3::UnitZ();
  const Mat3 along = d * d.transpose();
  const Mat3 across = Mat3(Vec3(1.0, 1.0, 0.0).asDiagonal()) - along;
  Mat3 stiffness = k(0, 0) * along + solution.pull / to.distance * across;
  stiffness -= k(0, 1) * d * up.transpose();
  stiffness -= k(1, 0) * up * d.transpose();
  stiffness += k(1, 1) * up * up.transpose();
  return stiffness;
}

}  // namespace

CatenarySite line_site(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W) {
  CatenarySite site;
  site.fairlead_z = fairlead_W.z();
  site.anchor_z = line.anchor_W.z();
  site.bed_z = spread.bed.height(fairlead_W.x(), fairlead_W.y());
  const double distance = line_direction(line, fairlead_W).distance;
  site.bed_descent = distance > 0.0 ? (site.bed_z - site.anchor_z) / distance : 0.0;
  return site;
}

LineDirection line_direction(const MooredLine& line, const Vec3& fairlead_W) {
  Vec3 to = line.anchor_W - fairlead_W;
  to.z() = 0.0;
  const double distance = to.norm();
  return distance > 0.0 ? LineDirection{distance, to / distance} : LineDirection{};
}

LinePull line_pull(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W,
                   const CatenarySolution* near) {
  LinePull pull;
  const LineDirection to = line_direction(line, fairlead_W);
  const CatenarySite site = line_site(spread, line, fairlead_W);
  const auto force = [](const CatenarySolution& solution, const Vec3& direction) {
    return Vec3(solution.pull * direction - solution.sink * Vec3::UnitZ());
  };
  pull.solution = solve_catenary(line.line, site, to.distance, near);
  if (pull.solution.error != CatenaryError::none) return pull;
  pull.force_W = force(pull.solution, to.direction_W);
  if (site.bed_descent == 0.0 && to.distance > 0.0) {
    pull.stiffness = straight_bed_stiffness(pull.solution, to);
    return pull;
  }
  // the bed slope below the line changes with its direction: differences include that
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 ends[2];
    for (const int side : {0, 1}) {
      const Vec3 shifted = fairlead_W + (side == 0 ? -kDifference : kDifference) * Vec3::Unit(axis);
      const LineDirection direction = line_direction(line, shifted);
      const CatenarySolution solution =
          solve_catenary(line.line, line_site(spread, line, shifted), direction.distance, &pull.solution);
      ends[side] = force(solution, direction.direction_W);
    }
    pull.stiffness.col(axis) = (ends[0] - ends[1]) / (2.0 * kDifference);
  }
  return pull;
}

MooringWrench mooring_wrench(const MooringSpread& spread, const HullPlace& hull, std::vector<CatenarySolution>& lines) {
  MooringWrench sum;
  const bool warm = lines.size() == spread.lines.size();
  lines.resize(spread.lines.size());
  for (std::size_t i = 0; i < spread.lines.size(); ++i) {
    const MooredLine& line = spread.lines[i];
    if (line.parted) continue;
    const Vec3 arm = hull.R_WV * line.fairlead_V, fairlead = hull.p_W + arm;
    LinePull pull = line_pull(spread, line, fairlead, warm ? &lines[i] : nullptr);
    if (pull.solution.error != CatenaryError::none) {
      sum.error = line_error_message(spread, line, fairlead, pull.solution.error);
      return sum;
    }
    lines[i] = std::move(pull.solution);
    const Mat3 a = cross_matrix(arm), f = cross_matrix(pull.force_W), &k = pull.stiffness;
    sum.load.head<3>() += pull.force_W;
    sum.load.tail<3>() += arm.cross(pull.force_W);
    sum.stiffness.topLeftCorner<3, 3>() += k;
    sum.stiffness.topRightCorner<3, 3>() -= k * a;
    sum.stiffness.bottomLeftCorner<3, 3>() += a * k;
    sum.stiffness.bottomRightCorner<3, 3>() -= f * a + a * k * a;
  }
  return sum;
}

std::string line_error_message(const MooringSpread& spread, const MooredLine& line, const Vec3& fairlead_W,
                               CatenaryError error) {
  const double chord = (line.anchor_W - fairlead_W).norm();
  switch (error) {
    case CatenaryError::too_short:
      return fmt::format("mooring line \"{}\" is too short to reach: {} of line for {} to its anchor", line.name,
                         shown(line.line.length(), "m", 2), shown(chord, "m", 2));
    case CatenaryError::below_bed:
      return fmt::format("mooring line \"{}\": its fairlead at z = {} lies below the sea bed at {}", line.name,
                         shown(fairlead_W.z(), "m", 2),
                         shown(spread.bed.height(fairlead_W.x(), fairlead_W.y()), "m", 2));
    case CatenaryError::no_shape:
    case CatenaryError::none:
      break;
  }
  const auto floats = [](const CatenaryPiece& piece) { return piece.weight_submerged < 0.0; };
  if (std::any_of(line.line.pieces.begin(), line.line.pieces.end(), floats)) {
    return fmt::format("mooring line \"{}\" would float on the water surface, which is not supported", line.name);
  }
  return fmt::format("mooring line \"{}\": no static shape was found between fairlead and anchor, {} apart", line.name,
                     shown(chord, "m", 2));
}

namespace {

/// Returns an error if the line is not fully defined.
MooringError find_description_error(const MooringLineDescription& line) {
  if (!line.segments.front().length && !line.tension) {
    return fmt::format("mooring line \"{}\" has neither a length of its first segment nor a tension", line.name);
  }
  if (!line.segments.front().length && !line.points.empty()) {
    return fmt::format(
        "mooring line \"{}\": give the length of its first segment, as its buoys and weights are located along it",
        line.name);
  }
  const auto at_fairlead = [](const LinePointDescription& point) { return point.at <= 1e-3; };
  if (std::any_of(line.points.begin(), line.points.end(), at_fairlead)) {
    return fmt::format("mooring line \"{}\": a buoy or weight is at its fairlead; move it along the line", line.name);
  }
  return std::nullopt;
}

}  // namespace

SpreadOutcome build_spread(const MooringsDescription& moorings, const SeabedSurface& bed, const Mat3& drawn) {
  SpreadOutcome outcome;
  outcome.spread.bed = bed;
  for (const MooringLineDescription& from : moorings.lines) {
    outcome.error = find_description_error(from);
    if (outcome.error) return outcome;
    MooredLine& line = outcome.spread.lines.emplace_back(moored_line(moorings, from, bed, drawn));
    if (!from.segments.front().length) outcome.error = set_drawn_length(outcome.spread, line, *from.tension, drawn);
    if (outcome.error) return outcome;
  }
  return outcome;
}

}  // namespace overbend
