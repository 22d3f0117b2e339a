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

constexpr int kHalvings = 18;     ///< Bisections of the horizontal tension; an initial shape need not be more accurate.
constexpr double kSteps = 250.0;  ///< Steps over the height of a vertical chain.

const Section& section_at_length(const Model& model, double from_top) {
  return model.sections[static_cast<std::size_t>(model.section_at(from_top))];
}

/// Start of the free span.
struct SpanStart {
  double from_top = 0.0, distance = 0.0, z = 0.0, tension = 0.0;
};

/// End of a chain and its points.
struct Chain {
  std::vector<double> length, distance, z, dip;  ///< From the start down.
  double end_z = 0.0;                            ///< Height of its level point, or of the end of the line [m].
  double end_length = 0.0;
  bool level = false;  ///< True if it ends level; otherwise the line ended first.
};

/// Integrates down from the start with horizontal tension H until the chain is level, the line ends, or it is below
/// `floor`.
Chain integrate_chain(const Model& model, const SpanStart& start, double H, double total, double floor, double step,
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
    const double below = V - h * weight_at(model, section_at_length(model, u + 0.5 * h), z);
    // The last piece ends at the level point.
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

/// Work of the weight between two points of the shape: the loss of tension on the way down [N].
double tension_loss(const Model& model, const LayShape& shape) {
  double sum = 0.0;
  for (std::size_t i = 1; i < shape.z.size(); ++i) {
    const double u = 0.5 * (shape.length[i] + shape.length[i - 1]);
    sum += weight_at(model, section_at_length(model, u), 0.5 * (shape.z[i] + shape.z[i - 1])) *
           (shape.z[i - 1] - shape.z[i]);
  }
  return sum;
}

/// Free span from `start` to a level end on the bed or to its anchor.
class FreeSpan {
 public:
  /// `landing`: assumed distance of the landing astern of the tensioner, which gives the depth of the bed [m].
  FreeSpan(const Model& model, const LayPlane& plane, double total, double landing)
      : model_(model), total_(total), pinned_(cable_at_far_end(model.description) && !is_dragged(model.description)) {
    bed_ = pinned_ ? pinned_height(model) : plane.bed(landing) - plane.radius;
    step_ = std::max(0.05, (plane.tensioner_W.z() - bed_) / kSteps);
  }

  /// Height of the axis at the end of the span, on the bed or at the anchor [m].
  double target(const Chain& chain) const {
    return pinned_ ? bed_ : bed_ + section_at_length(model_, chain.end_length).outer_radius();
  }

  /// Horizontal tension with which the span ends at its target; nullopt if not even a vertical line reaches it.
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
    return integrate_chain(model_, start, H, total_, bed_ - 10.0, step_, true);
  }

 private:
  /// True if the span is level, or ends, above its target.
  bool too_high(const SpanStart& start, double H) const {
    const Chain chain = integrate_chain(model_, start, H, total_, bed_ - 10.0, step_, false);
    return chain.end_z > target(chain);
  }

  const Model& model_;
  double total_;
  bool pinned_;
  double bed_ = 0.0, step_ = 0.1;
};

/// Length beyond that of any suspended line [m].
double unlimited_length(const Model& model, const LayPlane& plane) {
  return model.description.pipe.length.value_or(20.0 * (plane.tensioner_W.z() - plane.bed(0.0)) + 1e4);
}

SpanStart make_span_start(const Model& model, const LayShape& shape, double tension) {
  return {shape.length.back(), shape.distance.back(), shape.z.back(), tension - tension_loss(model, shape)};
}

/// Shape over the supports up to point `last`.
LayShape over_supports(const std::vector<GuidePoint>& points, std::size_t last) {
  LayShape shape;
  append_point(shape, 0.0, points[0].z, points[0].dip);
  for (std::size_t i = 1; i <= last; ++i) append_curve(shape, points[i]);
  shape.last_support = last == 0 ? 0.0 : shape.length.back();
  return shape;
}

/// Points in order of increasing distance from the tensioner; others are dropped.
std::vector<GuidePoint> in_order(const std::vector<GuidePoint>& points) {
  std::vector<GuidePoint> kept;
  for (const GuidePoint& point : points) {
    if (kept.empty() || point.distance > kept.back().distance + 1e-6) kept.push_back(point);
  }
  return kept;
}

/// True if a line that lies on the supports up to a point leaves it at least as steeply as it lies there. A line that
/// does not reach its end from there is vertical.
bool is_in_contact(const Model& model, const std::vector<GuidePoint>& points, std::size_t last, const FreeSpan& span,
                   double tension) {
  const SpanStart start = make_span_start(model, over_supports(points, last), tension);
  if (start.tension <= 0.0) return true;
  const std::optional<double> H = span.pull(start);
  return !H || std::acos(std::min(1.0, *H / start.tension)) >= points[last].dip;
}

/// Last support over which the line bends. The free span is steeper the higher it begins, so that all supports before
/// it are in contact as well.
std::size_t departure(const Model& model, const std::vector<GuidePoint>& points, const FreeSpan& span, double tension) {
  std::size_t over = 0, clear = points.size();
  while (clear - over > 1) {
    const std::size_t middle = (over + clear) / 2;
    (is_in_contact(model, points, middle, span, tension) ? over : clear) = middle;
  }
  return over;
}

/// Length of cable and head on the bed behind touchdown: the laid pipe that holds the line follows them [m].
double laid_length(const Model& model, const LayShape& shape) {
  return cable_at_top(model.description) ? std::max(0.0, pipe_start_distance(model.description) - shape.touchdown)
                                         : 0.0;
}

}  // namespace

double pinned_height(const Model& model) {
  const LayOperationDescription& lay = model.description.operation.lay;
  return is_dragged(model.description) ? -lay.winch->depth : -lay.anchor->depth;
}

double min_stage_top_tension(const Model& model, const LayPlane& plane) {
  const std::vector<GuidePoint> points = in_order(support_points(model, plane, model.mean_pose));
  const LayShape shape = over_supports(points, points.size() - 1);
  const bool pinned = cable_at_far_end(model.description) && !is_dragged(model.description);
  const double floor = pinned ? pinned_height(model) : plane.bed(0.0);
  const double top = shape.z.back(), step = (top - floor) / 4000.0;
  double weight = tension_loss(model, shape);
  for (int i = 0; i < 4000 && step > 0.0; ++i) {
    const double down = (i + 0.5) * step;
    weight += step * weight_at(model, section_at_length(model, shape.length.back() + down), top - down);
  }
  return weight;
}

namespace {

/// True if the free span ends on the bed, and not at an anchor of a cable.
bool ends_on_bed(const Model& model) {
  return !cable_at_far_end(model.description) || is_dragged(model.description);
}

LayShape shape_for_landing(const Model& model, const LayPlane& plane, double tension, double landing) {
  LayShape shape;
  const double total = unlimited_length(model, plane);
  const FreeSpan span(model, plane, total, landing);
  const std::vector<GuidePoint> points = in_order(support_points(model, plane, model.mean_pose));
  shape = over_supports(points, departure(model, points, span, tension));
  const SpanStart start = make_span_start(model, shape, tension);
  const std::optional<double> H = start.tension > 0.0 ? span.pull(start) : std::nullopt;
  if (!H) {
    shape.problem = fmt::format(
        "with {} at the top the line hangs vertically above its end point: the suspended weight needs at least {}",
        shown(tension, "N", 1), shown(min_stage_top_tension(model, plane), "N", 1));
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

/// Shape of the line down to its landing, with the landing found.
LayShape landed_shape(const Model& model, const LayPlane& plane, double tension) {
  constexpr double kNear = 1e-2;  // [m]
  LandingSearch landing(plane);
  LayShape shape = shape_for_landing(model, plane, tension, landing.assumed_distance());
  for (int pass = 1; pass < kMaxLandings && shape.problem.empty() && ends_on_bed(model); ++pass) {
    // On a rising bed keep the depth below the tensioner: the initial shape is then slightly lower than the line.
    const double landed = shape.distance.back();
    if (plane.bed(landed) > plane.bed(landing.assumed_distance()) || !landing.accept_landing(landed, kNear)) break;
    LayShape next = shape_for_landing(model, plane, tension, landing.assumed_distance());
    if (!next.problem.empty()) break;  // vertical over such a deep bed: left to Newton's method
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
