#include <algorithm>
#include <cmath>

#include "moorings/catenary.h"

namespace overbend {
namespace {

double length_before(const CatenaryLine& line, std::size_t piece) {
  double sum = 0.0;
  for (std::size_t i = 0; i < piece; ++i) sum += line.pieces[i].length;
  return sum;
}

double unstressed(const CatenaryLine& line, const LinePosition& position) {
  return length_before(line, position.piece) + position.into.v;
}

/// Advances along a part of one piece, across the water surface where it is met.
void advance_in_piece(CatenaryState& state, const CatenaryPiece& piece, double length) {
  for (double left = length; left > 0.0;) {
    const CatenaryStretch stretch = next_stretch(state, Dual(left), piece);
    advance_catenary(state, stretch.length, stretch.weight, piece.EA);
    left -= stretch.length.v;
    if (!stretch.to_surface) return;
    state.z = 0.0;
    state.above = !state.above;
  }
}

struct SuspendedPoint {
  CatenaryState state;
  double EA = 0.0;
};

/// State at an unstressed length within a span, from the start of the span.
SuspendedPoint suspended_point_at(const CatenaryLine& line, const CatenarySite& site, const CatenarySpan& span,
                                  double length) {
  SuspendedPoint suspended{span.start, line.pieces[std::min(span.from.piece, line.pieces.size() - 1)].EA};
  double arc_length = unstressed(line, span.from);
  for (std::size_t i = span.from.piece; i < line.pieces.size() && arc_length < length; ++i) {
    const double end = length_before(line, i) + line.pieces[i].length;
    advance_in_piece(suspended.state, line.pieces[i], std::min(end, length) - arc_length);
    suspended.EA = line.pieces[i].EA;
    arc_length = end;
    for (const CatenaryPoint& point : line.points) {
      if (point.behind != i || end >= length) continue;
      suspended.state.sink = suspended.state.sink + pull_up(point, suspended.state.z, site.bed_at(suspended.state.x));
    }
  }
  return suspended;
}

CatenaryPlace make_catenary_place(const SuspendedPoint& suspended) {
  const double pull = suspended.state.pull.v, sink = suspended.state.sink.v;
  const double tension = std::max(std::hypot(pull, sink), 1e-9), stretch = 1.0 + tension / suspended.EA;
  return {suspended.state.x.v, suspended.state.z.v, stretch * pull / tension, -stretch * sink / tension, false};
}

/// Part on the bed between a suspended span and the next one, or the line's end.
struct BedPart {
  double from = 0.0, to = 0.0;  ///< Unstressed lengths from the fairlead [m].
  double tension = 0.0;         ///< Tension at its start [N].
  double x0 = 0.0, z0 = 0.0, x1 = 0.0, z1 = 0.0;
};

/// Stretch at an unstressed length, and stretched length from the start of the part to it.
struct StretchedLength {
  double stretch = 1.0, length = 0.0;
};

StretchedLength stretched_at(const CatenaryLine& line, const BedPart& lying, double length) {
  StretchedLength result;
  double tension = lying.tension, arc_length = lying.from, end = 0.0;
  for (const CatenaryPiece& piece : line.pieces) {
    end += piece.length;
    const double part = std::min(end, length) - arc_length;
    if (part < 0.0) continue;
    const double rubs = piece.friction * std::max(piece.weight_submerged, 0.0);
    const double pulled = rubs > 0.0 ? std::min(part, tension / rubs) : part;
    result.length += part + (tension - 0.5 * rubs * pulled) * pulled / piece.EA;
    tension = std::max(tension - rubs * part, 0.0);
    result.stretch = 1.0 + tension / piece.EA;
    arc_length += part;
    if (end >= length) break;
    const std::size_t i = static_cast<std::size_t>(&piece - line.pieces.data());
    for (const CatenaryPoint& point : line.points) {  // clump weights add friction
      const bool rubs_here = point.behind == i && part > 0.0 && !point.is_suspended_below();
      const double rubs_there = rubs_here ? piece.friction * std::max(-point.pull_up, 0.0) : 0.0;
      tension = std::max(tension - rubs_there, 0.0);
    }
  }
  return result;
}

/// Interpolates between the ends, which are known from the solution.
CatenaryPlace place_on_bed(const CatenaryLine& line, const BedPart& lying, double length) {
  const StretchedLength part = stretched_at(line, lying, length), total = stretched_at(line, lying, lying.to);
  const double share = total.length > 0.0 ? part.length / total.length : 0.0;
  const double dx = lying.x1 - lying.x0, dz = lying.z1 - lying.z0, chord = std::max(std::hypot(dx, dz), 1e-9);
  return {lying.x0 + share * dx, lying.z0 + share * dz, part.stretch * dx / chord, part.stretch * dz / chord, true};
}

}  // namespace

CatenaryPlace catenary_place(const CatenaryLine& line, const CatenarySolution& solution, double length) {
  const CatenaryGeometry& trace = solution.trace;
  for (std::size_t i = 0; i < trace.span_count; ++i) {
    const CatenarySpan& span = trace.spans[i];
    const double to = unstressed(line, span.to);
    const bool last = i + 1 == trace.span_count;
    if (length <= to || (last && !trace.ends_on_bed)) {
      return make_catenary_place(suspended_point_at(line, trace.site, span, length));
    }
    const double next = last ? line.length() : unstressed(line, trace.spans[i + 1].from);
    if (length > next) continue;
    const SuspendedPoint down = suspended_point_at(line, trace.site, span, to);
    const CatenaryState& up = last ? trace.end : trace.spans[i + 1].start;
    return place_on_bed(
        line,
        {to, next, std::hypot(down.state.pull.v, down.state.sink.v), down.state.x.v, down.state.z.v, up.x.v, up.z.v},
        length);
  }
  return {};
}

}  // namespace overbend
