// Lengths that give a line the pull or the tension that is asked for.
#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "moorings/catenary.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 100;

CatenarySolution faulty(CatenaryFault fault) {
  CatenarySolution solution;
  solution.fault = fault;
  return solution;
}

/// A line of one length more than the chord between its ends is near what any wanted pull asks for.
void set_length_to_chord(CatenaryLine& line, const CatenarySite& site, double distance) {
  const double chord = std::hypot(distance, site.fairlead_z - site.anchor_z);
  const double rest = line.length() - line.pieces.front().length;
  line.pieces.front().length = std::max(chord - rest, 1e-3 * chord);
}

/// The first piece's length at which the line reaches the distance with a given pull: Newton inside an interval.
/// False where there is none above 0.
bool set_length(CatenaryLine& line, const CatenarySite& site, double distance, double pull, CatenaryTrace& trace) {
  double& length = line.pieces.front().length;
  double low = 0.0, high = kInfinity;
  double sink = pull;
  for (int i = 0; i < kMaxIterations; ++i) {
    trace = trace_catenary(line, site, pull, i == 0 ? sink : trace.sink.v);
    if (trace.fault != TraceFault::none) return false;
    const double miss = trace.reach.v - distance, slope = trace.reach[CatenaryUnknown::first];
    if (std::abs(miss) <= 1e-11 * distance) return true;
    (miss < 0.0 ? low : high) = length;
    const double newton = slope > 0.0 ? length - miss / slope : kInfinity;
    const bool inside = newton > low && newton < high;
    const double next = inside ? newton : (std::isfinite(high) ? 0.5 * (low + high) : 2.0 * length);
    if (next < 1e-9 * distance || next == length) return std::abs(miss) <= 1e-8 * distance;
    length = next;
  }
  return false;
}

}  // namespace

CatenarySolution set_length_for_pull(CatenaryLine& line, const CatenarySite& site, double distance, double pull) {
  if (site.has_bed && site.fairlead_z <= site.bed_z) return faulty(CatenaryFault::below_bed);
  if (line.pieces.front().length <= 0.0) set_length_to_chord(line, site, distance);
  CatenaryTrace trace;
  if (!set_length(line, site, distance, pull, trace)) return faulty(CatenaryFault::no_shape);
  CatenarySolution near;
  near.pull = pull;
  near.sink = trace.sink.v;
  return solve_catenary(line, site, distance, &near);
}

CatenarySolution set_length_for_tension(CatenaryLine& line, const CatenarySite& site, double distance, double tension) {
  using Of = CatenaryUnknown;
  if (site.has_bed && site.fairlead_z <= site.bed_z) return faulty(CatenaryFault::below_bed);
  if (line.pieces.front().length <= 0.0) set_length_to_chord(line, site, distance);
  double pull = 0.9 * tension, low = 0.0, high = tension;
  CatenaryTrace trace;
  for (int i = 0; i < kMaxIterations; ++i) {
    if (!set_length(line, site, distance, pull, trace)) return faulty(CatenaryFault::no_shape);
    const double found = std::hypot(pull, trace.sink.v);
    if (std::abs(found - tension) <= 1e-11 * tension) {
      CatenarySolution near;
      near.pull = pull;
      near.sink = trace.sink.v;
      return solve_catenary(line, site, distance, &near);
    }
    (found < tension ? low : high) = pull;
    // Along the lengths that keep the distance.
    const double sink_slope =
        trace.sink[Of::pull] - trace.sink[Of::first] * trace.reach[Of::pull] / trace.reach[Of::first];
    const double newton = pull - (found - tension) * found / (pull + trace.sink.v * sink_slope);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (next == pull || next < 1e-9 * tension) break;
    pull = next;
  }
  return faulty(CatenaryFault::no_shape);
}

}  // namespace overbend
