/// The shape of a line for a given horizontal pull at its fairlead: hanging spans that touch the bed without entering
/// it, and what lies between them. docs/theory/moorings.md derives it.
#pragma once

#include <array>

#include "base/constants.h"
#include "moorings/catenary_walk.h"

namespace overbend {

/// What a line hangs between, in its vertical plane.
struct CatenarySite {
  double fairlead_z = 0.0;   ///< Over mean water level [m].
  double anchor_z = 0.0;     ///< On a sloping bed the anchor lies on it [m].
  bool has_bed = true;       ///< Else the line hangs free.
  double bed_z = 0.0;        ///< Height of the bed under the fairlead [m].
  double bed_descent = 0.0;  ///< Fall of the bed per metre towards the anchor [-].

  /// Height of the bed at a distance from the fairlead; far below where there is none [m].
  Dual bed_at(const Dual& x) const { return has_bed ? bed_z - bed_descent * x : Dual(-kInfinity); }
};

/// A place by piece and unstressed length into it.
struct LinePosition {
  std::size_t piece = 0;
  Dual into;  ///< [m]
};

/// A hanging stretch, and where its shape starts.
struct CatenarySpan {
  CatenaryState start;
  LinePosition from, to;
};

/// Most spans that a line may hang in.
inline constexpr std::size_t kMaxSpans = 6;

enum class TraceFault { none, no_shape, floats, too_many_spans };

/// Of the duals: derivatives in pull, height and first length; none in start.
struct CatenaryTrace {  // NOLINT(clang-analyzer-optin.performance.Padding): in the order of subjects
  TraceFault fault = TraceFault::none;
  CatenarySite site;     ///< Where it was traced.
  Dual reach;            ///< Horizontal distance from fairlead to the line's end [m].
  Dual sink;             ///< Vertical force of the line at the fairlead, downwards positive [N].
  CatenaryState end;     ///< At the anchor; `sink` below zero where the line comes to it from below.
  double on_bed = 0.0;   ///< Unstressed length at rest on the bed [m].
  bool touches = false;  ///< The line reaches the bed before its end.
  double touchdown_s = 0.0, touchdown_x = 0.0;  ///< Unstressed length and distance from the fairlead to there [m].
  bool lies_to_end = false;                     ///< What leads to the anchor lies on the bed.
  std::array<CatenarySpan, kMaxSpans> spans;
  std::size_t span_count = 0;
};

/// Traces the line for a horizontal pull above 0 [N]. `sink_guess`: vertical force to start from [N].
CatenaryTrace trace_catenary(const CatenaryLine& line, const CatenarySite& site, double pull, double sink_guess);

}  // namespace overbend
