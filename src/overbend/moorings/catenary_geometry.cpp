#include "moorings/catenary_geometry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/constants.h"

namespace overbend {
namespace {

/// Maximum number of iterations for the start of one span; Newton needs 5, bisection 50.
constexpr int kMaxIterations = 200;
/// A gap below this share of the size is closed by the last linear step, to its square [-].
constexpr double kClose = 1e-9;
/// Maximum number of passages through the water surface; a line with more would float on it.
constexpr int kMaxPassages = 8;
/// Minimum tension left by friction, as a share of the line's weight, so that the part behind has a shape [-].
constexpr double kMinTension = 1e-9;

/// Line with the length of its first piece as an unknown, and its site.
struct Setting {
  const CatenaryLine& line;
  const CatenarySite& site;
  double min_tension = 0.0;  ///< [N]

  Dual length(std::size_t piece) const {
    const double value = line.pieces[piece].length;
    return piece == 0 ? Dual(value, CatenaryUnknown::first) : Dual(value);
  }
  Dual bed(const Dual& x) const { return site.bed_z - site.bed_descent * x; }
  /// Target height of the end of the line. On a sloping bed the end touches the bed at any distance, so that heights do
  /// not jump between the end and the part just in front of it; at the anchor both are equal.
  Dual end_level(const Dual& x) const { return site.has_bed && site.bed_descent != 0.0 ? bed(x) : Dual(site.anchor_z); }
  /// Vertical force of a line parallel to the bed.
  Dual along_bed(const Dual& pull) const { return site.bed_descent * pull; }
  /// True if a point or piece behind a position lifts the line off the bed.
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

/// Lowest point of a suspended span relative to the bed and the anchor.
struct LowestPlace {
  Dual gap = kInfinity;  ///< [m]
  CatenaryState state;
  LinePosition place;
  bool on_bed = false;                ///< If false, it is the end of the line.
  std::optional<std::size_t> weight;  ///< Index of the point of the line that is lowest.
};

void record_lowest(LowestPlace& lowest, const Dual& gap, const CatenaryState& state, const LinePosition& place) {
  if (gap.v >= lowest.gap.v) return;
  lowest = {gap, state, place, true, {}};
}

/// Records the point of a stretch of constant weight that is nearest to the bed, if it lies inside the stretch.
bool record_dip(const Setting& on, const CatenaryState& state, const LinePosition& place,
                const CatenaryStretch& stretch, double EA, LowestPlace& lowest) {
  const Dual level = on.along_bed(state.pull);
  if (!on.site.has_bed || stretch.weight <= 0.0 || state.sink.v <= level.v) return false;
  const Dual length = (state.sink - level) / stretch.weight;
  if (length.v >= stretch.length.v) return false;
  CatenaryState dip = state;
  advance_catenary(dip, length, stretch.weight, EA);
  dip.sink = on.along_bed(dip.pull);
  record_lowest(lowest, dip.z - on.bed(dip.x), dip, {place.piece, place.into + length});
  return true;
}

/// Passes the points at the end of a piece.
void pass_points(const Setting& on, CatenaryState& state, std::size_t piece, LowestPlace& lowest) {
  for (std::size_t i = 0; i < on.line.points.size(); ++i) {
    const CatenaryPoint& point = on.line.points[i];
    if (point.behind != piece) continue;
    const Dual level = on.along_bed(state.pull);
    const Dual behind = state.sink + pull_up(point, state.z, on.site.bed_at(state.x));
    if (on.site.has_bed && state.sink.v > level.v && behind.v < level.v) {
      const double before = lowest.gap.v;
      record_lowest(lowest, state.z - on.bed(state.x), state, {piece, on.length(piece)});
      if (lowest.gap.v < before) lowest.weight = i;
    }
    state.sink = behind;
  }
}

/// Result for a span start that leaves the line oscillating about the water surface: the start has to be lower.
LowestPlace too_high(const CatenaryState& state, const LinePosition& place) {
  return {1e9, state, place, false, {}};
}

/// Integrates from a position to the end of the line. Returns the lowest point on the way.
LowestPlace integrate_span(const Setting& on, CatenaryState state, LinePosition place, bool may_rise) {
  LowestPlace lowest;
  int passages = 0;
  for (; place.piece < on.line.pieces.size(); place = {place.piece + 1, 0.0}) {
    const CatenaryPiece& piece = on.line.pieces[place.piece];
    Dual left = on.length(place.piece) - place.into;
    while (left.v > 0.0) {
      const CatenaryStretch stretch = next_stretch(state, left, piece);
      if (record_dip(on, state, place, stretch, piece.EA, lowest) && !may_rise) return lowest;
      advance_catenary(state, stretch.length, stretch.weight, piece.EA);
      place.into = place.into + stretch.length;
      if (!stretch.to_surface) break;
      state.z = 0.0;
      state.above = !state.above;
      if (++passages > kMaxPassages) return too_high(state, place);
      left = left - stretch.length;
    }
    pass_points(on, state, place.piece, lowest);
  }
  const Dual gap = state.z - on.end_level(state.x);
  if (gap.v < lowest.gap.v) lowest = {gap, state, place, false, {}};
  return lowest;
}

/// Line on the bed. `tension`: along the line, reduced by the weight passed since touchdown.
struct BedState {
  CatenaryState state;
  LinePosition place;
  Dual tension;
  double length = 0.0;  ///< Unstressed length on the bed [m].
};

/// Loss of tension per weight, by the slope of the bed and friction.
double loss(const Setting& on, double friction) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  return cosine * (on.site.bed_descent + friction);
}

/// Advances on the bed over a length of one piece. The tension does not fall below 0; the part beyond is unloaded.
void advance_on_bed(const Setting& on, BedState& rest, const Dual& length, const CatenaryPiece& piece) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  const double fall = piece.weight_submerged * loss(on, piece.friction);
  const bool to_zero = fall > 0.0 && rest.tension.v < fall * length.v;
  const Dual pulled = to_zero ? rest.tension / fall : length;
  const Dual stretch = pulled * (rest.tension - (0.5 * fall) * pulled) / piece.EA;
  rest.tension = to_zero ? Dual(on.min_tension) : rest.tension - fall * length;
  rest.state.x = rest.state.x + cosine * (length + stretch);
  rest.state.z = on.bed(rest.state.x);
  rest.state.pull = cosine * rest.tension;
  rest.state.sink = on.along_bed(rest.state.pull);
  rest.place.into = rest.place.into + length;
  rest.length += length.v;
}

/// Reduces the tension by friction and slope at a weight of the line on the bed. `held`: part of it carried by the bed.
void pass_weight_on_bed(const Setting& on, BedState& rest, double friction, double weight, const Dual& held) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  const Dual after = rest.tension - weight * cosine * on.site.bed_descent - (friction * cosine) * held;
  rest.tension = after.v > 0.0 ? after : Dual(on.min_tension);
  rest.state.pull = cosine * rest.tension;
  rest.state.sink = on.along_bed(rest.state.pull);
}

/// Advances on the bed from a touchdown point until the weight `used` lies on the bed, until a point or piece lifts the
/// line, or to its end. Returns the state at the start of the next span.
BedState integrate_on_bed(const Setting& on, const LowestPlace& from, const Dual& used) {
  const double cosine = 1.0 / std::hypot(1.0, on.site.bed_descent);
  BedState rest{from.state, from.place, {}, 0.0};
  rest.state.above = false;
  rest.tension = cosine * (from.state.pull + on.site.bed_descent * from.state.sink);
  rest.state.sink = on.along_bed(rest.state.pull);
  Dual left = used;
  // Weight, carried by the bed, of the point at the touchdown.
  Dual landed = from.weight ? from.state.sink - on.along_bed(from.state.pull) : Dual(0.0);
  std::size_t point = from.weight.value_or(0);
  while (rest.place.piece < on.line.pieces.size()) {
    const CatenaryPiece& piece = on.line.pieces[rest.place.piece];
    const Dual length = on.length(rest.place.piece) - rest.place.into;
    if (length.v > 0.0) {
      if (piece.weight_submerged <= 0.0) return rest;
      const Dual max_length = left / piece.weight_submerged;
      if (max_length.v < length.v) {
        advance_on_bed(on, rest, max_length, piece);
        return rest;
      }
      advance_on_bed(on, rest, length, piece);
      left = left - piece.weight_submerged * length;
    }
    for (; point < on.line.points.size() && on.line.points[point].behind <= rest.place.piece; ++point) {
      if (on.line.points[point].behind < rest.place.piece) continue;
      if (on.line.points[point].is_suspended_below()) continue;  // it lies on the bed next to the line
      const double up = on.line.points[point].pull_up;
      const Dual carried = -up - landed;
      landed = 0.0;
      if (up > 0.0 || left.v < carried.v) {  // the line leaves the bed here
        rest.state.sink = rest.state.sink + (up > 0.0 ? Dual(up) : left - carried);
        rest.place = {rest.place.piece + 1, 0.0};
        return rest;
      }
      pass_weight_on_bed(on, rest, piece.friction, -up, carried);
      left = left - carried;
    }
    rest.place = {rest.place.piece + 1, 0.0};
  }
  return rest;
}

/// Weight that can lie on the bed behind a position before a point or piece lifts the line or the line ends.
double max_weight_on_bed(const Setting& on, const LowestPlace& from) {
  double sum = 0.0;
  for (std::size_t i = from.place.piece; i < on.line.pieces.size(); ++i) {
    const CatenaryPiece& piece = on.line.pieces[i];
    const double length = piece.length - (i == from.place.piece ? from.place.into.v : 0.0);
    if (piece.weight_submerged <= 0.0 && length > 0.0) return sum;
    sum += piece.weight_submerged * length;
    for (std::size_t k = from.weight.value_or(0); k < on.line.points.size(); ++k) {
      if (on.line.points[k].behind != i || on.line.points[k].is_suspended_below()) continue;
      if (on.line.points[k].pull_up > 0.0) return sum;
      sum -= on.line.points[k].pull_up;
      if (from.weight == k) sum -= from.state.sink.v - on.along_bed(from.state.pull).v;
    }
  }
  return sum;
}

/// Finds the start at which the lowest point of a span just touches the bed: the gap falls as the start grows. Newton
/// in a closing interval.
template <class Integrate>
std::optional<LowestPlace> find_touching_start(Integrate&& integrate_from, double guess, double low, double high,
                                               double scale) {
  double start = guess, last_width = kInfinity;
  LowestPlace lowest;
  for (int i = 0; i < kMaxIterations; ++i) {
    lowest = integrate_from(start);
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

double compute_line_weight(const CatenaryLine& line) {
  double sum = 0.0;
  for (const CatenaryPiece& piece : line.pieces) sum += std::abs(piece.weight_submerged) * piece.length;
  return sum;
}

Dual without_start(const Dual& value, const Dual& gap) {
  return eliminate(value, gap, CatenaryUnknown::start);
}

CatenaryState without_start(const CatenaryState& state, const Dual& gap) {
  return {without_start(state.x, gap), without_start(state.z, gap), without_start(state.pull, gap),
          without_start(state.sink, gap), state.above};
}

/// Eliminates the span start, defined by a zero gap, from all derivatives.
void eliminate_start(LowestPlace& lowest) {
  const Dual gap = lowest.gap;
  lowest.state = without_start(lowest.state, gap);
  lowest.place.into = without_start(lowest.place.into, gap);
}

/// Unstressed length from the fairlead to a position.
double length_to(const CatenaryLine& line, const LinePosition& place) {
  double sum = place.into.v;
  for (std::size_t i = 0; i < place.piece; ++i) sum += line.pieces[i].length;
  return sum;
}

void add_span(CatenaryGeometry& trace, const CatenaryState& start, const LinePosition& from, const LinePosition& to) {
  trace.spans[trace.span_count++] = {start, from, to};
}

/// Computes the part behind a touchdown point and the spans lifted off the bed by buoys or a raised anchor. `lowest`:
/// touchdown point of the last span.
void compute_after_touchdown(const Setting& on, LowestPlace lowest, double scale, CatenaryGeometry& trace) {
  while (lowest.on_bed) {
    if (!on.lifts_behind(lowest.place.piece) && !on.anchor_is_up()) {
      const BedState rest = integrate_on_bed(on, lowest, kInfinity);
      trace.on_bed += rest.length;
      trace.end = rest.state;
      trace.ends_on_bed = true;
      return;
    }
    if (trace.span_count == kMaxSpans) {
      trace.error = GeometryError::too_many_spans;
      return;
    }
    const double max_weight = max_weight_on_bed(on, lowest);
    BedState rest;
    const auto lift_at = [&](double used) {
      rest = integrate_on_bed(on, lowest, Dual(used, CatenaryUnknown::start));
      return integrate_span(on, rest.state, rest.place, true);
    };
    // The maximum weight would lie exactly up to the lifting point: start just before it.
    const std::optional<LowestPlace> next = find_touching_start(lift_at, 0.5 * max_weight, 0.0, max_weight, scale);
    if (!next) {
      trace.error = GeometryError::no_shape;
      return;
    }
    trace.on_bed += rest.length;
    const Dual gap = next->gap;
    add_span(trace, without_start(rest.state, gap), {rest.place.piece, without_start(rest.place.into, gap)},
             next->place);
    lowest = *next;
    eliminate_start(lowest);
  }
  trace.end = lowest.state;
}

}  // namespace

CatenaryGeometry compute_catenary_geometry(const CatenaryLine& line, const CatenarySite& site, double pull,
                                           double sink_guess) {
  CatenaryGeometry trace;
  trace.site = site;
  const Setting on{line, site, kMinTension * compute_line_weight(line)};
  const double scale = std::abs(site.fairlead_z - site.anchor_z) + line.length();
  CatenaryState start;
  start.z = Dual(site.fairlead_z, CatenaryUnknown::height);
  start.pull = Dual(pull, CatenaryUnknown::pull);
  start.above = site.fairlead_z > 0.0;
  const bool may_rise = on.lifts_behind(0) || on.anchor_is_up();
  const auto integrate_from_fairlead = [&](double sink) {
    start.sink = Dual(sink, CatenaryUnknown::start);
    return integrate_span(on, start, {0, 0.0}, may_rise);
  };
  std::optional<LowestPlace> lowest =
      find_touching_start(integrate_from_fairlead, sink_guess, -kInfinity, kInfinity, scale);
  if (!lowest) {
    trace.error = GeometryError::no_shape;
    return trace;
  }
  trace.sink = without_start(start.sink, lowest->gap);
  start = without_start(start, lowest->gap);
  eliminate_start(*lowest);
  add_span(trace, start, {0, 0.0}, lowest->place);
  trace.touches = lowest->on_bed;
  trace.touchdown_s = length_to(line, lowest->place);
  trace.touchdown_x = lowest->state.x.v;
  compute_after_touchdown(on, std::move(*lowest), scale, trace);
  trace.reach = trace.end.x;
  return trace;
}

}  // namespace overbend
