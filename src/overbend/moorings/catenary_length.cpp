// Line lengths for a given horizontal force or fairlead tension.
#include <algorithm>
#include <cmath>

#include "base/constants.h"
#include "moorings/catenary.h"

namespace overbend {
namespace {

constexpr int kMaxIterations = 100;

CatenarySolution failed_solution(CatenaryError error) {
  CatenarySolution solution;
  solution.error = error;
  return solution;
}

/// First guess: a line as long as the chord between its ends is close to the solution for any force.
void set_length_to_chord(CatenaryLine& line, const CatenarySite& site, double distance) {
  const double chord = std::hypot(distance, site.fairlead_z - site.anchor_z);
  const double rest = line.length() - line.pieces.front().length;
  line.pieces.front().length = std::max(chord - rest, 1e-3 * chord);
}

/// Finds the length of the first piece at which the line reaches the distance at a given force, by Newton in a closing
/// interval. Returns false if there is none above 0.
bool set_length(CatenaryLine& line, const CatenarySite& site, double distance, double pull, CatenaryGeometry& trace) {
  double& length = line.pieces.front().length;
  double low = 0.0, high = kInfinity;
  double sink = pull;
  for (int i = 0; i < kMaxIterations; ++i) {
    trace = compute_catenary_geometry(line, site, pull, i == 0 ? sink : trace.sink.v);
    if (trace.error != GeometryError::none) return false;
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
  if (site.has_bed && site.fairlead_z <= site.bed_z) return failed_solution(CatenaryError::below_bed);
  if (line.pieces.front().length <= 0.0) set_length_to_chord(line, site, distance);
  CatenaryGeometry trace;
  if (!set_length(line, site, distance, pull, trace)) return failed_solution(CatenaryError::no_shape);
  CatenarySolution near;
  near.pull = pull;
  near.sink = trace.sink.v;
  return solve_catenary(line, site, distance, &near);
}

CatenarySolution set_length_for_tension(CatenaryLine& line, const CatenarySite& site, double distance, double tension) {
  using Of = CatenaryUnknown;
  if (site.has_bed && site.fairlead_z <= site.bed_z) return failed_solution(CatenaryError::below_bed);
  if (line.pieces.front().length <= 0.0) set_length_to_chord(line, site, distance);
  double pull = 0.9 * tension, low = 0.0, high = tension;
  CatenaryGeometry trace;
  for (int i = 0; i < kMaxIterations; ++i) {
    if (!set_length(line, site, distance, pull, trace)) return failed_solution(CatenaryError::no_shape);
    const double found = std::hypot(pull, trace.sink.v);
    if (std::abs(found - tension) <= 1e-11 * tension) {
      CatenarySolution near;
      near.pull = pull;
      near.sink = trace.sink.v;
      return solve_catenary(line, site, distance, &near);
    }
    (found < tension ? low : high) = pull;
    // Derivative along lengths at constant distance.
    const double sink_slope =
        trace.sink[Of::pull] - trace.sink[Of::first] * trace.reach[Of::pull] / trace.reach[Of::first];
    const double newton = pull - (found - tension) * found / (pull + trace.sink.v * sink_slope);
    const double next = newton > low && newton < high ? newton : 0.5 * (low + high);
    if (next == pull || next < 1e-9 * tension) break;
    pull = next;
  }
  return failed_solution(CatenaryError::no_shape);
}

}  // namespace overbend
