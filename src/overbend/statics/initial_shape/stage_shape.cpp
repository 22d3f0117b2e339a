#include "statics/initial_shape/stage_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/dragged_shape.h"
#include "statics/initial_shape/shape_curve.h"

namespace overbend {
namespace {

constexpr int kHalvings = 18;     ///< Of the horizontal tension: a guess need not be closer.
constexpr double kSteps = 250.0;  ///< Of a chain that hangs plumb.

const Section& section_of(const Model& model, double from_top) {
  return model.sections[static_cast<std::size_t>(model.section_at(from_top))];
}

/// Where the free span begins.
struct SpanStart {
  double from_top = 0.0, distance = 0.0, z = 0.0, tension = 0.0;
};

/// Where a chain ends, and what it is like on the way.
struct Chain {
  std::vector<double> length, distance, z, dip;  ///< From the start down.
  double end_z = 0.0;                            ///< Where it is level, or where the line ends [m].
  double end_length = 0.0;
  bool level = false;  ///< It is level there; else the line ended first.
};

/// Down from the start with horizontal tension H: until it is level, the line ends, or it is below `floor`.
Chain hang_down(const Model& model, const SpanStart& start, double H, double total, double floor, double step,
                bool keep) {
  Chain chain;
  double V = std::sqrt(std::max(start.tension * start.tension - H * H, 0.0));
  double u = start.from_top, x = start.distance, z = start.z;
  while (true) {
    if (keep) {
      chain.length.push_back(u);
      chain.distance.push_back(x);
      chain.z.push_back(z);
      chain.dip.push_back(std::atan2(V, H));
    }
    chain.level = V <= 0.0;
    if (chain.level || u >= total || z < floor) break;
    const double h = std::min(step, total - u);
    const double below = V - h * weight_at(model, section_of(model, u + 0.5 * h), z);
    // The last piece ends where it is level.
    const double share = below < 0.0 ? V / (V - below) : 1.0;
    const double middle = std::atan2(0.5 * (V + std::max(below, 0.0)), H);
    x += share * h * std::cos(middle);
    z -= share * h * std::sin(middle);
    u += share * h;
    V = share < 1.0 ? 0.0 : below;
  }
  chain.end_z = z;
  chain.end_length = u;
  return chain;
}

/// Work of the weight between two points of the guess: what the tension loses on the way down.
double lost(const Model& model, const LayShape& shape) {
  double sum = 0.0;
  for (std::size_t i = 1; i < shape.z.size(); ++i) {
    const double u = 0.5 * (shape.length[i] + shape.length[i - 1]);
    sum += weight_at(model, section_of(model, u), 0.5 * (shape.z[i] + shape.z[i - 1])) * (shape.z[i - 1] - shape.z[i]);
  }
  return sum;
}

/// A free span that begins at `start`, and ends level on the bed or at its anchor.
class FreeSpan {
 public:
  /// `landing`: how far astern of the tensioner the span is taken to land; there the bed has its depth.
  FreeSpan(const Model& model, const LayPlane& plane, double total, double landing)
      : model_(model), total_(total), pinned_(cable_at_far_end(model.description) && !is_dragged(model.description)) {
    bed_ = pinned_ ? pinned_height(model) : plane.bed(landing) - plane.radius;
    step_ = std::max(0.05, (plane.tensioner_W.z() - bed_) / kSteps);
  }

  /// Height of the axis where the line would lie or be pinned [m].
  double target(const Chain& chain) const {
    return pinned_ ? bed_ : bed_ + section_of(model_, chain.end_length).outer_radius();
  }

  /// Horizontal tension with which the span ends where it should; none where even a plumb line does not reach.
  std::optional<double> pull(const SpanStart& start) const {
    double low = 1e-4 * start.tension, high = start.tension;
    if (too_high(start, low)) return std::nullopt;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (too_high(start, middle) ? high : low) = middle;
    }
    return low;
  }

  Chain shape(const SpanStart& start, double H) const {
    return hang_down(model_, start, H, total_, bed_ - 10.0, step_, true);
  }

 private:
  /// Whether the span is level, or ends, above where it should.
  bool too_high(const SpanStart& start, double H) const {
    const Chain chain = hang_down(model_, start, H, total_, bed_ - 10.0, step_, false);
    return chain.end_z > target(chain);
  }

  const Model& model_;
  double total_;
  bool pinned_;
  double bed_ = 0.0, step_ = 0.1;
};

/// Beyond any line that hangs.
double far_beyond(const Model& model, const LayPlane& plane) {
  return model.description.pipe.length.value_or(20.0 * (plane.tensioner_W.z() - plane.bed(0.0)) + 1e4);
}

SpanStart end_of(const Model& model, const LayShape& shape, double tension) {
  return {shape.length.back(), shape.distance.back(), shape.z.back(), tension - lost(model, shape)};
}

/// Over the supports up to point `last`.
LayShape over_supports(const std::vector<GuidePoint>& points, std::size_t last) {
  LayShape shape;
  append_point(shape, 0.0, points[0].z, points[0].dip);
  for (std::size_t i = 1; i <= last; ++i) append_curve(shape, points[i]);
  shape.last_support = last == 0 ? 0.0 : shape.length.back();
  return shape;
}

/// Points that lie behind each other, from the tensioner on.
std::vector<GuidePoint> in_order(const std::vector<GuidePoint>& points) {
  std::vector<GuidePoint> kept;
  for (const GuidePoint& at : points) {
    if (kept.empty() || at.distance > kept.back().distance + 1e-6) kept.push_back(at);
  }
  return kept;
}

/// Whether a line that lies over the supports up to a point leaves it no flatter than it lies there. One that does not
/// reach its end from there hangs plumb.
bool bends_over(const Model& model, const std::vector<GuidePoint>& points, std::size_t last, const FreeSpan& span,
                double tension) {
  const SpanStart start = end_of(model, over_supports(points, last), tension);
  if (start.tension <= 0.0) return true;
  const std::optional<double> H = span.pull(start);
  return !H || std::acos(std::min(1.0, *H / start.tension)) >= points[last].dip;
}

/// The last support that the line bends over; the free span is the steeper the higher it begins, so that all before it
/// are, too.
std::size_t departure(const Model& model, const std::vector<GuidePoint>& points, const FreeSpan& span, double tension) {
  std::size_t over = 0, clear = points.size();
  while (clear - over > 1) {
    const std::size_t middle = (over + clear) / 2;
    (bends_over(model, points, middle, span, tension) ? over : clear) = middle;
  }
  return over;
}

/// What lies of cable and head behind touchdown: laid pipe holds the line, so it comes after them [m].
double laid_length(const Model& model, const LayShape& shape) {
  return cable_at_top(model.description) ? std::max(0.0, pipe_begins(model.description) - shape.touchdown) : 0.0;
}

}  // namespace

double pinned_height(const Model& model) {
  const LayOperationDescription& lay = model.description.operation.lay;
  return is_dragged(model.description) ? -lay.winch->depth : -lay.anchor->depth;
}

double least_stage_tension(const Model& model, const LayPlane& plane) {
  const std::vector<GuidePoint> points = in_order(support_points(model, plane, model.mean_pose));
  const LayShape shape = over_supports(points, points.size() - 1);
  const bool pinned = cable_at_far_end(model.description) && !is_dragged(model.description);
  const double floor = pinned ? pinned_height(model) : plane.bed(0.0);
  const double top = shape.z.back(), step = (top - floor) / 4000.0;
  double weight = lost(model, shape);
  for (int i = 0; i < 4000 && step > 0.0; ++i) {
    const double down = (i + 0.5) * step;
    weight += step * weight_at(model, section_of(model, shape.length.back() + down), top - down);
  }
  return weight;
}

namespace {

/// Whether the free span ends on the bed, and not where a cable is pinned.
bool lands(const Model& model) {
  return !cable_at_far_end(model.description) || is_dragged(model.description);
}

LayShape shape_that_lands(const Model& model, const LayPlane& plane, double tension, double landing) {
  LayShape shape;
  const double total = far_beyond(model, plane);
  const FreeSpan span(model, plane, total, landing);
  const std::vector<GuidePoint> points = in_order(support_points(model, plane, model.mean_pose));
  shape = over_supports(points, departure(model, points, span, tension));
  const SpanStart start = end_of(model, shape, tension);
  const std::optional<double> H = start.tension > 0.0 ? span.pull(start) : std::nullopt;
  if (!H) {
    shape.problem = fmt::format(
        "with {} at the top the line hangs plumb above the place where it should end: at least {} are needed for the "
        "weight of what hangs",
        shown(tension, "N", 1), shown(least_stage_tension(model, plane), "N", 1));
    return shape;
  }
  shape.bottom_tension = *H;
  const Chain chain = span.shape(start, *H);
  if (shape.length.size() == 1 && model.description.tensioner.guide == Guide::pinned) {
    shape.dip[0] = chain.dip[0];
  }
  for (std::size_t i = 1; i < chain.z.size(); ++i) append_point(shape, chain.distance[i], chain.z[i], chain.dip[i]);
  shape.touchdown = shape.length.back();
  return shape;
}

}  // namespace

namespace {

/// The line down to where it lands, for the landing found.
LayShape landed_shape(const Model& model, const LayPlane& plane, double tension) {
  constexpr double kNear = 1e-2;  // [m]
  LandingSearch landing(plane);
  LayShape shape = shape_that_lands(model, plane, tension, landing.at());
  for (int pass = 1; pass < kLandings && shape.problem.empty() && lands(model); ++pass) {
    // A bed that rises is met from the depth under the tensioner: a guess that hangs a little lower than the line does.
    const double there = shape.distance.back();
    if (plane.bed(there) > plane.bed(landing.at()) || !landing.follow(there, kNear)) break;
    LayShape next = shape_that_lands(model, plane, tension, landing.at());
    if (!next.problem.empty()) break;  // it hangs plumb over a bed so deep: Newton's method has the last word
    shape = std::move(next);
  }
  return shape;
}

}  // namespace

LayShape stage_shape(const Model& model, const LayPlane& plane, double tension) {
  LayShape shape = landed_shape(model, plane, tension);
  if (!shape.problem.empty()) return shape;
  if (is_dragged(model.description)) return dragged_shape(model, plane, tension, std::move(shape));
  const double tail =
      model.description.pipe.length
          ? *model.description.pipe.length - shape.touchdown
          : laid_length(model, shape) +
                tail_beyond_attachments(model, shape.touchdown,
                                        tail_length(model, shape.bottom_tension, shape.touchdown - shape.last_support));
  if (tail > 1e-6) append_tail(shape, plane, tail);
  shape.total = model.description.pipe.length.value_or(shape.length.back());
  return shape;
}

}  // namespace overbend
