#include "moorings/catenary.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "base/require.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 200;
/// No mooring line bears such a strain: it does not reach [-].
constexpr double kMaxStrain = 0.25;
/// A miss of this share of the length is closed by the last linear step, to its square [-].
constexpr double kClose = 1e-9;

double abs_weight(const CatenaryLine& line) {
  double sum = 0.0;
  for (const CatenaryPiece& piece : line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  for (const CatenaryPoint& point : line.points) sum += std::abs(point.pull_up);
  return sum;
}

/// Vertical force to start from: of a line of even weight that touches the bed or hangs free.
double guessed_sink(const CatenarySite& site, double length, double weight, double distance, double pull) {
  const double rise = site.fairlead_z - site.anchor_z;
  const double w = weight / length;
  if (site.has_bed && rise > 0.0 && w > 0.0) {
    const double touching = std::sqrt(w * rise * (2.0 * pull + w * rise));
    if (touching < weight) return touching;
  }
  return pull * rise / std::max(distance, 1e-3 * length) + 0.5 * weight;
}

/// Pull to start from (Jonkman 2007, equation 2-38).
double guessed_pull(const CatenarySite& site, double length, double weight, double distance) {
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

void fill(CatenarySolution& solution, const CatenaryTrace& trace, double pull) {
  using Of = CatenaryUnknown;
  solution.trace = trace;
  solution.pull = pull;
  solution.sink = trace.sink.v;
  solution.anchor_pull = trace.end.pull.v;
  solution.anchor_rise = trace.end.sink.v;
  solution.anchor_uplift = trace.lies_to_end ? 0.0 : trace.end.sink.v;
  if (solution.slack) {  // the pull stays 0 whatever moves
    solution.stiffness(1, 1) = trace.sink[Of::height];
    return;
  }
  // The distance is given: the pull follows what changes.
  const double by_distance = 1.0 / trace.reach[Of::pull];
  const double by_height = -trace.reach[Of::height] * by_distance;
  const double by_length = -trace.reach[Of::first] * by_distance;
  const double sink_by_pull = trace.sink[Of::pull];
  solution.stiffness << by_distance, by_height, sink_by_pull * by_distance,
      trace.sink[Of::height] + sink_by_pull * by_height;
  solution.by_length << by_length, trace.sink[Of::first] + sink_by_pull * by_length;
}

/// No line pulls less than this share of its weight: below, it is slack.
constexpr double kLeastPull = 1e-9;

CatenarySolution faulty(CatenaryFault fault) {
  CatenarySolution solution;
  solution.fault = fault;
  return solution;
}

/// One step of Newton inside an interval (low, high) that closes; where it leaves it, the geometric mean or a factor.
double next_pull(double pull, double newton, double low, double high) {
  if (newton > low && newton < high) return newton;
  if (std::isfinite(high)) return low > 0.0 ? std::sqrt(low * high) : 0.1 * high;
  return 4.0 * pull;
}

double predicted_sink(const CatenaryTrace& trace, double more_pull) {
  return trace.sink.v + trace.sink[CatenaryUnknown::pull] * more_pull;
}

}  // namespace

CatenarySolution solve_catenary(const CatenaryLine& line, const CatenarySite& site, double distance,
                                const CatenarySolution* near) {
  const double length = line.length();
  if (site.has_bed && site.fairlead_z <= site.bed_z) return faulty(CatenaryFault::below_bed);
  if (!reaches(line, site, distance)) return faulty(CatenaryFault::too_short);
  const double target = std::max(distance, 1e-9 * length);
  const double weight = std::max(abs_weight(line), 1e-12 * line.pieces.front().EA);
  const double least = kLeastPull * weight;
  const bool warm = near != nullptr && near->fault == CatenaryFault::none && near->pull > least;
  double pull = warm ? near->pull : guessed_pull(site, length, weight, target);
  double sink = warm ? near->sink : guessed_sink(site, length, weight, target, pull);
  double low = 0.0, high = kInfinity;
  CatenarySolution solution;
  for (int i = 0; i < kMaxIterations; ++i) {
    const CatenaryTrace trace = trace_catenary(line, site, pull, sink);
    if (trace.fault != TraceFault::none) return faulty(CatenaryFault::no_shape);
    const double miss = trace.reach.v - target;
    (miss < 0.0 ? low : high) = pull;
    const double slope = trace.reach[CatenaryUnknown::pull];
    const double newton = slope > 0.0 ? pull - miss / slope : kInfinity;
    const bool close = std::abs(miss) <= kClose * length && slope > 0.0;
    solution.slack = pull <= least && miss >= 0.0;
    if (close || solution.slack || (std::isfinite(high) && high - low <= 1e-15 * high)) {
      if (!close && !solution.slack && std::abs(miss) > 1e-6 * length) return faulty(CatenaryFault::no_shape);
      if (solution.slack) {
        fill(solution, trace, 0.0);
      } else {
        const double last = close ? newton : pull;
        fill(solution, trace_catenary(line, site, last, predicted_sink(trace, last - pull)), last);
      }
      return solution;
    }
    const double next = std::max(next_pull(pull, newton, low, high), least);
    sink = predicted_sink(trace, next - pull);
    pull = next;
  }
  return faulty(CatenaryFault::no_shape);
}

}  // namespace overbend
