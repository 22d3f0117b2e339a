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

double unstressed(const CatenaryLine& line, const LinePosition& at) {
  return length_before(line, at.piece) + at.into.v;
}

/// Hangs along a part of one piece, through the water surface where it comes to it.
void go(CatenaryState& at, const CatenaryPiece& piece, double length) {
  for (double left = length; left > 0.0;) {
    const CatenaryStretch stretch = next_stretch(at, Dual(left), piece);
    hang(at, stretch.length, stretch.weight, piece.EA);
    left -= stretch.length.v;
    if (!stretch.to_surface) return;
    at.z = 0.0;
    at.above = !at.above;
  }
}

struct Hung {
  CatenaryState state;
  double EA = 0.0;
};

/// From the start of a span to an unstressed length within it.
Hung hung_at(const CatenaryLine& line, const CatenarySite& site, const CatenarySpan& span, double length) {
  Hung hung{span.start, line.pieces[std::min(span.from.piece, line.pieces.size() - 1)].EA};
  double at = unstressed(line, span.from);
  for (std::size_t i = span.from.piece; i < line.pieces.size() && at < length; ++i) {
    const double end = length_before(line, i) + line.pieces[i].length;
    go(hung.state, line.pieces[i], std::min(end, length) - at);
    hung.EA = line.pieces[i].EA;
    at = end;
    for (const CatenaryPoint& point : line.points) {
      if (point.behind != i || end >= length) continue;
      hung.state.sink = hung.state.sink + pull_up(point, hung.state.z, site.bed_at(hung.state.x));
    }
  }
  return hung;
}

CatenaryPlace place_of(const Hung& hung) {
  const double pull = hung.state.pull.v, sink = hung.state.sink.v;
  const double tension = std::max(std::hypot(pull, sink), 1e-9), stretch = 1.0 + tension / hung.EA;
  return {hung.state.x.v, hung.state.z.v, stretch * pull / tension, -stretch * sink / tension, false};
}

/// What lies between a hanging span and the next, or the end.
struct Lying {
  double from = 0.0, to = 0.0;  ///< Unstressed lengths from the fairlead [m].
  double tension = 0.0;         ///< Where it begins [N].
  double x0 = 0.0, z0 = 0.0, x1 = 0.0, z1 = 0.0;
};

/// Stretch, and stretched length from where it begins, at an unstressed length.
struct Stretched {
  double stretch = 1.0, length = 0.0;
};

Stretched stretched_at(const CatenaryLine& line, const Lying& lying, double length) {
  Stretched now;
  double tension = lying.tension, at = lying.from, end = 0.0;
  for (const CatenaryPiece& piece : line.pieces) {
    end += piece.length;
    const double part = std::min(end, length) - at;
    if (part < 0.0) continue;
    const double rubs = piece.friction * std::max(piece.weight_submerged, 0.0);
    const double pulled = rubs > 0.0 ? std::min(part, tension / rubs) : part;
    now.length += part + (tension - 0.5 * rubs * pulled) * pulled / piece.EA;
    tension = std::max(tension - rubs * part, 0.0);
    now.stretch = 1.0 + tension / piece.EA;
    at += part;
    if (end >= length) break;
    const std::size_t i = static_cast<std::size_t>(&piece - line.pieces.data());
    for (const CatenaryPoint& point : line.points) {  // clumps rub besides
      const bool rubs_here = point.behind == i && part > 0.0 && !point.hangs_under();
      const double rubs_there = rubs_here ? piece.friction * std::max(-point.pull_up, 0.0) : 0.0;
      tension = std::max(tension - rubs_there, 0.0);
    }
  }
  return now;
}

/// Between its ends, which the solution knows.
CatenaryPlace place_on_bed(const CatenaryLine& line, const Lying& lying, double length) {
  const Stretched here = stretched_at(line, lying, length), whole = stretched_at(line, lying, lying.to);
  const double share = whole.length > 0.0 ? here.length / whole.length : 0.0;
  const double dx = lying.x1 - lying.x0, dz = lying.z1 - lying.z0, way = std::max(std::hypot(dx, dz), 1e-9);
  return {lying.x0 + share * dx, lying.z0 + share * dz, here.stretch * dx / way, here.stretch * dz / way, true};
}

}  // namespace

CatenaryPlace catenary_place(const CatenaryLine& line, const CatenarySolution& solution, double length) {
  const CatenaryTrace& trace = solution.trace;
  for (std::size_t i = 0; i < trace.span_count; ++i) {
    const CatenarySpan& span = trace.spans[i];
    const double to = unstressed(line, span.to);
    const bool last = i + 1 == trace.span_count;
    if (length <= to || (last && !trace.lies_to_end)) return place_of(hung_at(line, trace.site, span, length));
    const double next = last ? line.length() : unstressed(line, trace.spans[i + 1].from);
    if (length > next) continue;
    const Hung down = hung_at(line, trace.site, span, to);
    const CatenaryState& up = last ? trace.end : trace.spans[i + 1].start;
    return place_on_bed(
        line,
        {to, next, std::hypot(down.state.pull.v, down.state.sink.v), down.state.x.v, down.state.z.v, up.x.v, up.z.v},
        length);
  }
  return {};
}

}  // namespace overbend
