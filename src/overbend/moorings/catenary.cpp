#include "moorings/catenary.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/require.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 200;
/// Strain limit beyond which the line cannot reach its anchor; no mooring line bears it [-].
constexpr double kMaxStrain = 0.25;
/// A miss below this share of the length is closed by the last linear step, to its square [-].
constexpr double kClose = 1e-9;

double abs_weight(const CatenaryLine& line) {
  double sum = 0.0;
  for (const CatenaryPiece& piece : line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  for (const CatenaryPoint& point : line.points) sum += std::abs(point.pull_up);
  return sum;
}

/// Initial vertical force, for a line of uniform weight that touches the bed or is suspended freely.
double estimate_sink(const CatenarySite& site, double length, double weight, double distance, double pull) {
  const double rise = site.fairlead_z - site.anchor_z;
  const double w = weight / length;
  if (site.has_bed && rise > 0.0 && w > 0.0) {
    const double touching = std::sqrt(w * rise * (2.0 * pull + w * rise));
    if (touching < weight) return touching;
  }
  return pull * rise / std::max(distance, 1e-3 * length) + 0.5 * weight;
}

/// Initial horizontal force (Jonkman 2007, equation 2-38).
double estimate_pull(const CatenarySite& site, double length, double weight, double distance) {
  const double rise = site.fairlead_z - site.anchor_z;
  const double chord2 = distance * distance + rise * rise;
  const double sag =
      length * length > chord2 ? std::sqrt(3.0 * ((length * length - rise * rise) / (distance * distance) - 1.0)) : 0.2;
  return std::max(weight / length * distance / (2.0 * sag), 1e-6 * weight);
}

bool reaches(const CatenaryLine& line, const CatenarySite& site, double distance) {
  const double chord = std::hypot(distance, site.fairlead_z - site.anchor_z);
  return chord <= line.length() * (1.0 + kMaxStrain);
}

void fill(CatenarySolution& solution, const CatenaryGeometry& trace, double pull) {
  using Of = CatenaryUnknown;
  solution.trace = trace;
  solution.pull = pull;
  solution.sink = trace.sink.v;
  solution.anchor_pull = trace.end.pull.v;
  solution.anchor_rise = trace.end.sink.v;
  solution.anchor_uplift = trace.ends_on_bed ? 0.0 : trace.end.sink.v;
  if (solution.slack) {  // the horizontal force stays 0 under any change
    solution.stiffness(1, 1) = trace.sink[Of::height];
    return;
  }
  // At given distance the horizontal force follows the changes.
  const double by_distance = 1.0 / trace.reach[Of::pull];
  const double by_height = -trace.reach[Of::height] * by_distance;
  const double by_length = -trace.reach[Of::first] * by_distance;
  const double sink_by_pull = trace.sink[Of::pull];
  solution.stiffness << by_distance, by_height, sink_by_pull * by_distance,
      trace.sink[Of::height] + sink_by_pull * by_height;
  solution.by_length << by_length, trace.sink[Of::first] + sink_by_pull * by_length;
}

/// Smallest horizontal force as a share of the line's weight; below it the line is slack.
constexpr double kMinPull = 1e-9;

CatenarySolution failed_solution(CatenaryError error) {
  CatenarySolution solution;
  solution.error = error;
  return solution;
}

/// Newton step if inside the closing interval (low, high); otherwise the geometric mean or a constant factor.
double next_pull(double pull, double newton, double low, double high) {
  if (newton > low && newton < high) return newton;
  if (std::isfinite(high)) return low > 0.0 ? std::sqrt(low * high) : 0.1 * high;
  return 4.0 * pull;
}

double predicted_sink(const CatenaryGeometry& trace, double more_pull) {
  return trace.sink.v + trace.sink[CatenaryUnknown::pull] * more_pull;
}

}  // namespace

CatenarySolution solve_catenary(const CatenaryLine& line, const CatenarySite& site, double distance,
                                const CatenarySolution* near) {
  const double length = line.length();
  if (site.has_bed && site.fairlead_z <= site.bed_z) return failed_solution(CatenaryError::below_bed);
  if (!reaches(line, site, distance)) return failed_solution(CatenaryError::too_short);
  const double target = std::max(distance, 1e-9 * length);
  const double weight = std::max(abs_weight(line), 1e-12 * line.pieces.front().EA);
  const double min_pull = kMinPull * weight;
  const bool warm = near != nullptr && near->error == CatenaryError::none && near->pull > min_pull;
  double pull = warm ? near->pull : estimate_pull(site, length, weight, target);
  double sink = warm ? near->sink : estimate_sink(site, length, weight, target, pull);
  double low = 0.0, high = kInfinity;
  CatenarySolution solution;
  for (int i = 0; i < kMaxIterations; ++i) {
    const CatenaryGeometry trace = compute_catenary_geometry(line, site, pull, sink);
    if (trace.error != GeometryError::none) return failed_solution(CatenaryError::no_shape);
    const double miss = trace.reach.v - target;
    (miss < 0.0 ? low : high) = pull;
    const double slope = trace.reach[CatenaryUnknown::pull];
    const double newton = slope > 0.0 ? pull - miss / slope : kInfinity;
    const bool close = std::abs(miss) <= kClose * length && slope > 0.0;
    solution.slack = pull <= min_pull && miss >= 0.0;
    if (close || solution.slack || (std::isfinite(high) && high - low <= 1e-15 * high)) {
      if (!close && !solution.slack && std::abs(miss) > 1e-6 * length) return failed_solution(CatenaryError::no_shape);
      if (solution.slack) {
        fill(solution, trace, 0.0);
      } else {
        const double last = close ? newton : pull;
        fill(solution, compute_catenary_geometry(line, site, last, predicted_sink(trace, last - pull)), last);
      }
      return solution;
    }
    const double next = std::max(next_pull(pull, newton, low, high), min_pull);
    sink = predicted_sink(trace, next - pull);
    pull = next;
  }
  return failed_solution(CatenaryError::no_shape);
}

}  // namespace overbend
