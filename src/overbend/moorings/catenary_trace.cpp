#include "moorings/catenary_trace.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"

namespace overbend {
namespace {

/// Iterations for the start of one span; Newton needs five, halving of the interval fifty.
constexpr int kMaxIterations = 200;
/// A gap of this share of the size is closed by the last linear step, to its square [-].
constexpr double kClose = 1e-9;
/// A line that passes the water surface more often would float on it.
constexpr int kMaxPassages = 8;
/// Friction leaves this share of the line's weight as tension, so that what stands behind has a shape [-].
constexpr double kLeastTension = 1e-9;

/// The line with its first length as an unknown, and the ground it is over.
struct Setting {
  const CatenaryLine& line;
  const CatenarySite& site;
  double least_tension = 0.0;  ///< [N]

  Dual length(std::size_t piece) const {
    const double value = line.pieces[piece].length;
    return piece == 0 ? Dual(value, CatenaryUnknown::first) : Dual(value);
  }
  Dual bed(const Dual& x) const { return site.bed_z - site.bed_descent * x; }
  /// Height to which the line's end belongs. On a sloping bed the end touches wherever it comes to, so that heights do
  /// not jump between the end and what lies just before it; at the anchor it is the same.
  Dual end_level(const Dual& x) const { return site.has_bed && site.bed_descent != 0.0 ? bed(x) : Dual(site.anchor_z); }
  /// Vertical force of a line that has the direction of the bed.
  Dual along_bed(const Dual& pull) const { return site.bed_descent * pull; }
  /// Whether something behind a position lifts the line off the bed.
  bool lifts_behind(std::size_t piece) const {
    for (std::size_t i = piece; i < line.pieces.size(); ++i) {
      if (line.pieces[i].weight_submerged <= 0.0) return true;
    }
    return std::any_of(line.points.begin(), line.points.end(),
                       [&](const CatenaryPoint& point) { return point.behind >= piece && point.pull_up > 0.0; });
  }
  bool anchor_is_up() const {
    return site.anchor_z > -kInfinity && site.has_bed && site.anchor_z > site.bed_z + 1e-6 && site.bed_descent == 0.0;
  }
};

/// The lowest place of a hanging span over bed and anchor.
struct LowestPlace {
  Dual gap = kInfinity;  ///< [m]
  CatenaryState at;
  LinePosition place;
  bool on_bed = false;                ///< Else it is the line's end.
  std::optional<std::size_t> weight;  ///< It is this point of the line.
};

void consider(LowestPlace& lowest, const Dual& gap, const CatenaryState& at, const LinePosition& place) {
  if (gap.v >= lowest.gap.v) return;
  lowest = {gap, at, place, true, {}};
}

/// Where a stretch of constant weight is nearest to the bed, if that is inside it.
bool consider_dip(const Setting& on, const CatenaryState& at, const LinePosition& place, const CatenaryStretch& stretch,
                  double EA, LowestPlace& lowest) {
  const Dual level = on.along_bed(at.pull);
  if (!on.site.has_bed || stretch.weight <= 0.0 || at.sink.v <= level.v) return false;
  const Dual length = (at.sink - level) / stretch.weight;
  if (length.v >= stretch.length.v) return false;
  CatenaryState there = at;
  hang(there, length, stretch.weight, EA);
  there.sink = on.along_bed(there.pull);
  consider(lowest, there.z - on.bed(there.x), there, {place.piece, place.into + length});
  return true;
}

/// Passes the points at the end of a piece.
void pass_points(const Setting& on, CatenaryState& at, std::size_t piece, LowestPlace& lowest) {
  for (std::size_t i = 0; i < on.line.points.size(); ++i) {
    const CatenaryPoint& point = on.line.points[i];
    if (point.behind != piece) continue;
    const Dual level = on.along_bed(at.pull);
    const Dual behind = at.sink + pull_up(point, at.z, on.site.bed_at(at.x));
    if (on.site.has_bed && at.sink.v > level.v && behind.v < level.v) {
      const double before = lowest.gap.v;
      consider(lowest, at.z - on.bed(at.x), at, {piece, on.length(piece)});
      if (lowest.gap.v < before) lowest.weight = i;
    }
    at.sink = behind;
  }
}

/// What a start says that leaves the line hopping over the surface: it has to be lower.
LowestPlace too_high(const CatenaryState& at, const LinePosition& place) {
  return {1e9, at, place, false, {}};
}

/// Hangs from a place to the end of the line; what is lowest on the way.
LowestPlace fly(const Setting& on, CatenaryState at, LinePosition place, bool may_rise) {
  LowestPlace lowest;
  int passages = 0;
  for (; place.piece < on.line.pieces.size(); place = {place.piece + 1, 0.0}) {
    const CatenaryPiece& piece = on.line.pieces[place.piece];
    Dual left = on.length(place.piece) - place.into;
    while (left.v > 0.0) {
      const CatenaryStretch stretch = next_stretch(at, left, piece);
      if (consider_dip(on, at, place, stretch, piece.EA, lowest) && !may_rise) return lowest;
      hang(at, stretch.length, stretch.weight, piece.EA);
      place.into = place.into + stretch.length;
      if (!stretch.to_surface) break;
      at.z = 0.0;
      at.above = !at.above;
      if (++passages > kMaxPassages) return too_high(at, place);
      left = left - stretch.length;
    }
    pass_points(on, at, place.piece, lowest);
  }
  const Dual gap = at.z - on.end_level(at.x);
  if (gap.v < lowest.gap.v) lowest = {gap, at, place, false, {}};
  return lowest;
}

/// A line at rest on the bed; `tension` along it, the weight used up since it came to rest.
struct Resting {
  CatenaryState at;
  LinePosition place;
  Dual tension;
  double length = 0.0;  ///< Unstressed, lying [m].
};

/// Tension lost per weight: the bed's fall and friction.
double loss(const Setting& on, double friction) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  return cosine * (on.site.bed_descent + friction);
}

/// Lies for a length of one piece. The tension does not fall below 0: what is beyond is not pulled.
void lie(const Setting& on, Resting& rest, const Dual& length, const CatenaryPiece& piece) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  const double fall = piece.weight_submerged * loss(on, piece.friction);
  const bool to_zero = fall > 0.0 && rest.tension.v < fall * length.v;
  const Dual pulled = to_zero ? rest.tension / fall : length;
  const Dual stretch = pulled * (rest.tension - (0.5 * fall) * pulled) / piece.EA;
  rest.tension = to_zero ? Dual(on.least_tension) : rest.tension - fall * length;
  rest.at.x = rest.at.x + cosine * (length + stretch);
  rest.at.z = on.bed(rest.at.x);
  rest.at.pull = cosine * rest.tension;
  rest.at.sink = on.along_bed(rest.at.pull);
  rest.place.into = rest.place.into + length;
  rest.length += length.v;
}

/// Friction and slope take their part where a weight of the line rests on the bed: `held` is what the bed carries.
void rest_weight(const Setting& on, Resting& rest, double friction, double weight, const Dual& held) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  const Dual after = rest.tension - weight * cosine * on.site.bed_descent - (friction * cosine) * held;
  rest.tension = after.v > 0.0 ? after : Dual(on.least_tension);
  rest.at.pull = cosine * rest.tension;
  rest.at.sink = on.along_bed(rest.at.pull);
}

/// From where a span came to rest, lies on until the weight `used` lies on the bed, or to where something lifts the
/// line, or to its end. Leaves the state that the next span starts with.
Resting lie_on(const Setting& on, const LowestPlace& from, const Dual& used) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  Resting rest{from.at, from.place, {}, 0.0};
  rest.at.above = false;
  rest.tension = cosine * (from.at.pull + on.site.bed_descent * from.at.sink);
  rest.at.sink = on.along_bed(rest.at.pull);
  Dual left = used;
  // Weight of the point on which the span came down that the bed carries.
  Dual landed = from.weight ? from.at.sink - on.along_bed(from.at.pull) : Dual(0.0);
  std::size_t point = from.weight.value_or(0);
  while (rest.place.piece < on.line.pieces.size()) {
    const CatenaryPiece& piece = on.line.pieces[rest.place.piece];
    const Dual length = on.length(rest.place.piece) - rest.place.into;
    if (length.v > 0.0) {
      if (piece.weight_submerged <= 0.0) return rest;
      const Dual most = left / piece.weight_submerged;
      if (most.v < length.v) {
        lie(on, rest, most, piece);
        return rest;
      }
      lie(on, rest, length, piece);
      left = left - piece.weight_submerged * length;
    }
    for (; point < on.line.points.size() && on.line.points[point].behind <= rest.place.piece; ++point) {
      if (on.line.points[point].behind < rest.place.piece) continue;
      if (on.line.points[point].hangs_under()) continue;  // it lies beside the line
      const double up = on.line.points[point].pull_up;
      const Dual carried = -up - landed;
      landed = 0.0;
      if (up > 0.0 || left.v < carried.v) {  // the line leaves the bed here
        rest.at.sink = rest.at.sink + (up > 0.0 ? Dual(up) : left - carried);
        rest.place = {rest.place.piece + 1, 0.0};
        return rest;
      }
      rest_weight(on, rest, piece.friction, -up, carried);
      left = left - carried;
    }
    rest.place = {rest.place.piece + 1, 0.0};
  }
  return rest;
}

/// The weight that can lie on the bed behind a place before something lifts the line or it ends.
double weight_to_lie(const Setting& on, const LowestPlace& from) {
  double sum = 0.0;
  for (std::size_t i = from.place.piece; i < on.line.pieces.size(); ++i) {
    const CatenaryPiece& piece = on.line.pieces[i];
    const double length = piece.length - (i == from.place.piece ? from.place.into.v : 0.0);
    if (piece.weight_submerged <= 0.0 && length > 0.0) return sum;
    sum += piece.weight_submerged * length;
    for (std::size_t k = from.weight.value_or(0); k < on.line.points.size(); ++k) {
      if (on.line.points[k].behind != i || on.line.points[k].hangs_under()) continue;
      if (on.line.points[k].pull_up > 0.0) return sum;
      sum -= on.line.points[k].pull_up;
      if (from.weight == k) sum -= from.at.sink.v - on.along_bed(from.at.pull).v;
    }
  }
  return sum;
}

/// Finds the start at which the lowest place of a span just touches: the gap falls as the start grows. Newton inside
/// an interval that closes.
template <class Fly>
std::optional<LowestPlace> touching(Fly&& fly_from, double guess, double low, double high, double scale) {
  double start = guess, last_width = kInfinity;
  LowestPlace lowest;
  for (int i = 0; i < kMaxIterations; ++i) {
    lowest = fly_from(start);
    const double gap = lowest.gap.v, slope = lowest.gap[CatenaryUnknown::start];
    if (!std::isfinite(gap)) return std::nullopt;
    if (std::abs(gap) <= kClose * scale && slope < 0.0) return lowest;
    (gap > 0.0 ? low : high) = start;
    double next = slope < 0.0 ? start - gap / slope : kInfinity;
    const bool bracketed = std::isfinite(low) && std::isfinite(high);
    const double width = high - low;
    if (!(next > low && next < high) || (bracketed && i > 8 && width > 0.5 * last_width)) {
      if (bracketed) {
        next = 0.5 * (low + high);
      } else {
        const double step = std::max(std::abs(start), 1.0);
        next = gap > 0.0 ? start + step : start - step;
      }
    }
    last_width = width;
    const bool closed = std::abs(next - start) <= 4e-16 * std::max(std::abs(start), std::abs(next));
    if (closed || next == start) return std::abs(gap) <= 1e-7 * scale ? std::optional(lowest) : std::nullopt;
    start = next;
  }
  return std::abs(lowest.gap.v) <= 1e-7 * scale ? std::optional(lowest) : std::nullopt;
}

double weight_of(const CatenaryLine& line) {
  double sum = 0.0;
  for (const CatenaryPiece& piece : line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  return sum;
}

Dual without_start(const Dual& value, const Dual& gap) {
  return eliminate(value, gap, CatenaryUnknown::start);
}

CatenaryState without_start(const CatenaryState& at, const Dual& gap) {
  return {without_start(at.x, gap), without_start(at.z, gap), without_start(at.pull, gap), without_start(at.sink, gap),
          at.above};
}

/// The start is where the gap is zero: takes it out of everything that depends on it.
void settle(LowestPlace& lowest) {
  const Dual gap = lowest.gap;
  lowest.at = without_start(lowest.at, gap);
  lowest.place.into = without_start(lowest.place.into, gap);
}

/// Unstressed length from the fairlead to a place.
double length_to(const CatenaryLine& line, const LinePosition& place) {
  double sum = place.into.v;
  for (std::size_t i = 0; i < place.piece; ++i) sum += line.pieces[i].length;
  return sum;
}

void add_span(CatenaryTrace& trace, const CatenaryState& start, const LinePosition& from, const LinePosition& to) {
  trace.spans[trace.span_count++] = {start, from, to};
}

/// What lies behind a touchdown, and the spans that buoys or a raised anchor lift from it. `lowest`: where the last
/// span touches.
void trace_behind(const Setting& on, LowestPlace lowest, double scale, CatenaryTrace& trace) {
  while (lowest.on_bed) {
    if (!on.lifts_behind(lowest.place.piece) && !on.anchor_is_up()) {
      const Resting rest = lie_on(on, lowest, kInfinity);
      trace.on_bed += rest.length;
      trace.end = rest.at;
      trace.lies_to_end = true;
      return;
    }
    if (trace.span_count == kMaxSpans) {
      trace.fault = TraceFault::too_many_spans;
      return;
    }
    const double most = weight_to_lie(on, lowest);
    Resting rest;
    const auto lift_at = [&](double used) {
      rest = lie_on(on, lowest, Dual(used, CatenaryUnknown::start));
      return fly(on, rest.at, rest.place, true);
    };
    // The whole weight would lie exactly to the lifting place: start just before it.
    const std::optional<LowestPlace> next = touching(lift_at, 0.5 * most, 0.0, most, scale);
    if (!next) {
      trace.fault = TraceFault::no_shape;
      return;
    }
    trace.on_bed += rest.length;
    const Dual gap = next->gap;
    add_span(trace, without_start(rest.at, gap), {rest.place.piece, without_start(rest.place.into, gap)}, next->place);
    lowest = *next;
    settle(lowest);
  }
  trace.end = lowest.at;
}

}  // namespace

CatenaryTrace trace_catenary(const CatenaryLine& line, const CatenarySite& site, double pull, double sink_guess) {
  CatenaryTrace trace;
  trace.site = site;
  const Setting on{line, site, kLeastTension * weight_of(line)};
  const double scale = std::abs(site.fairlead_z - site.anchor_z) + line.length();
  CatenaryState start;
  start.z = Dual(site.fairlead_z, CatenaryUnknown::height);
  start.pull = Dual(pull, CatenaryUnknown::pull);
  start.above = site.fairlead_z > 0.0;
  const bool may_rise = on.lifts_behind(0) || on.anchor_is_up();
  const auto hang_from = [&](double sink) {
    start.sink = Dual(sink, CatenaryUnknown::start);
    return fly(on, start, {0, 0.0}, may_rise);
  };
  std::optional<LowestPlace> lowest = touching(hang_from, sink_guess, -kInfinity, kInfinity, scale);
  if (!lowest) {
    trace.fault = TraceFault::no_shape;
    return trace;
  }
  trace.sink = without_start(start.sink, lowest->gap);
  start = without_start(start, lowest->gap);
  settle(*lowest);
  add_span(trace, start, {0, 0.0}, lowest->place);
  trace.touches = lowest->on_bed;
  trace.touchdown_s = length_to(line, lowest->place);
  trace.touchdown_x = lowest->at.x.v;
  trace_behind(on, std::move(*lowest), scale, trace);
  trace.reach = trace.end.x;
  return trace;
}

}  // namespace overbend
