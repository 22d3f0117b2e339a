#include "statics/initial_shape/lay_shape.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "statics/initial_shape/shape_curve.h"

namespace overbend {
namespace {

/// Free span from touchdown upwards: dense points, the first on the bed.
struct FreeSpan {
  std::vector<double> length, distance, z, dip;  ///< From touchdown; distance increases towards the vessel.
};

/// Integrates a chain upwards with horizontal tension H and weight w(z) until it reaches the height `top`.
FreeSpan integrate_free_span(const Model& model, double H, double bed_z, double slope, double top) {
  FreeSpan span;
  const double step = std::max(0.05, (top - bed_z) / 1500.0);
  const double start = std::atan(-slope);  // seen towards the vessel, the bed falls if it rises astern
  double x = 0.0, z = bed_z, s = 0.0, V = H * std::tan(start);
  while (z < top && span.z.size() < 400000) {
    const double dip = std::atan2(V, H);
    span.length.push_back(s);
    span.distance.push_back(x);
    span.z.push_back(z);
    span.dip.push_back(dip);
    V += step * weight_at(model, model.pipe_section(), z);
    const double middle = std::atan2(V, H);
    x += step * std::cos(0.5 * (dip + middle));
    z += step * std::sin(0.5 * (dip + middle));
    s += step;
  }
  return span;
}

double dip_at_height(const FreeSpan& span, double z) {
  const auto above = std::lower_bound(span.z.begin(), span.z.end(), z);
  return above == span.z.end() ? span.dip.back() : span.dip[static_cast<std::size_t>(above - span.z.begin())];
}

void append_span(LayShape& shape, const FreeSpan& span) {
  const double x0 = shape.distance.back(), z0 = shape.z.back();
  std::size_t i = static_cast<std::size_t>(std::lower_bound(span.z.begin(), span.z.end(), z0) - span.z.begin());
  i = std::min(i, span.z.size() - 1);
  const double x_top = span.distance[i];
  while (i-- > 0) {
    append_point(shape, x0 + x_top - span.distance[i], span.z[i], span.dip[i]);
  }
  shape.touchdown = shape.length.back();
}

/// On a shaped bed the span ends where it first meets the bed, possibly at a crest before the assumed landing.
void land_on_shape(LayShape& shape, const LayPlane& plane) {
  for (std::size_t i = 0; i < shape.length.size(); ++i) {
    if (shape.length[i] <= shape.last_support || shape.z[i] >= plane.bed(shape.distance[i])) continue;
    for (std::vector<double>* values : {&shape.length, &shape.distance, &shape.z, &shape.dip}) values->resize(i + 1);
    shape.touchdown = shape.length.back();
    return;
  }
}

/// Last support over which the pipe bends down no more than the free span would.
std::size_t departure(const std::vector<GuidePoint>& points, const FreeSpan& span) {
  std::size_t last = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (points[i].dip <= dip_at_height(span, points[i].z)) {
      last = i;
    }
  }
  return last;
}

}  // namespace

LayPlane lay_plane(const Model& model, const VesselPose& pose) {
  const TensionerDescription& tensioner = model.description.tensioner;
  const LayRoute route = lay_route(model);
  const Vec3 tensioner_W = point_from_ramp(model, pose, Vec3(tensioner.x, 0.0, tensioner.z));
  LayPlane plane{route, tensioner_W, route.direction(0.0), route.port(0.0), model.seabed.surface, 0.0, 0.0};
  plane.radius = model.pipe_section().outer_radius();
  const Vec3 guide_W = direction_from_ramp(pose, Vec3(std::cos(tensioner.incline), 0.0, -std::sin(tensioner.incline)));
  plane.guide_dip = std::atan2(-guide_W.z(), guide_W.dot(plane.astern_W));
  return plane;
}

double LayPlane::bed(double distance) const {
  const Vec3 point = route.place(distance);
  return surface.height(point.x(), point.y()) + radius;
}

double LayPlane::bed_slope(double distance) const {
  const Vec3 point = route.place(distance);
  return surface.slope(point.x(), point.y(), route.direction(distance));
}

double suspended_pipe_weight(const Model& model, const LayPlane& plane, const Section& section, double bed_z) {
  const int steps = 4000;
  const double dz = (plane.tensioner_W.z() - bed_z) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    sum += dz * weight_at(model, section, bed_z + (i + 0.5) * dz);
  }
  return sum;
}

double suspended_pipe_weight(const Model& model, const LayPlane& plane, double bed_z) {
  double min_weight = std::numeric_limits<double>::infinity();
  for (const Section& section : model.sections) {
    min_weight = std::min(min_weight, suspended_pipe_weight(model, plane, section, bed_z));
  }
  return min_weight;
}

bool LandingSearch::accept_landing(double landed, double near) {
  if (std::abs(plane_->bed(landed) - plane_->bed(assumed_distance_)) < near) return false;
  // On a bed that rises steeply astern, successive landings overshoot alternately, up to where the bed is above the
  // tensioner: the landings on both sides bound the next one.
  (landed > assumed_distance_ ? nearest_ : farthest_) = assumed_distance_;
  assumed_distance_ = landed > nearest_ && landed < farthest_ ? landed : 0.5 * (nearest_ + farthest_);
  while (plane_->bed(assumed_distance_) >= plane_->tensioner_W.z() && assumed_distance_ - nearest_ > 1e-3) {
    farthest_ = assumed_distance_;
    assumed_distance_ = 0.5 * (nearest_ + farthest_);
  }
  return true;
}

LayShape lay_shape(const Model& model, const LayPlane& plane, double tension) {
  const Section& pipe = model.pipe_section();
  LayShape shape;
  // Under little tension the pipe is supported by its bending stiffness: limit the curvature of the catenary to what
  // bending allows.
  const double stiff = 1.5 * std::cbrt(pipe.EI * pipe.weight_submerged * pipe.weight_submerged);
  LandingSearch landing(plane);
  for (int pass = 0; pass < kMaxLandings; ++pass) {
    shape = LayShape{};
    const double bed_z = plane.bed(landing.assumed_distance());
    const double H = std::max(tension - suspended_pipe_weight(model, plane, bed_z), stiff);
    shape.bottom_tension = H;
    const std::vector<GuidePoint> points = support_points(model, plane, model.mean_pose);
    const FreeSpan span =
        integrate_free_span(model, H, bed_z, plane.bed_slope(landing.assumed_distance()), plane.tensioner_W.z());
    if (span.z.empty() || span.z.back() < bed_z + 0.5 * (plane.tensioner_W.z() - bed_z)) {
      shape.problem = plane.bed_slope(landing.assumed_distance()) > 0.0
                          ? "the seabed rises astern so steeply that it meets the pipe before its free span: check the "
                            "slope of the seabed and its direction"
                          : "the seabed falls away astern faster than the pipe: there is no touchdown";
      return shape;
    }
    const std::size_t last = departure(points, span);
    const bool free_top = last == 0 && model.description.tensioner.guide == Guide::pinned;
    append_point(shape, 0.0, points[0].z, free_top ? span.dip.back() : points[0].dip);
    for (std::size_t i = 1; i <= last; ++i) {
      if (points[i].distance > shape.distance.back() + 1e-6) {
        append_curve(shape, points[i]);
      }
    }
    shape.last_support = last == 0 ? 0.0 : shape.length.back();
    append_span(shape, span);
    if (!landing.accept_landing(shape.distance.back(), 1e-3)) break;
  }
  if (plane.surface.shape() != nullptr) land_on_shape(shape, plane);
  double tail = tail_length(model, shape.bottom_tension, shape.touchdown - shape.last_support);
  if (!plane.route.straight()) {  // pipe that slides in a bend is held by the straight pipe behind it
    constexpr double kBehind = 200.0, kMaxLength = 3000.0;  // [m]
    const double bends = plane.route.pieces()->back().s - shape.distance.back();
    tail = std::clamp(bends + kBehind, tail, std::max(tail, kMaxLength));
  }
  append_tail(shape, plane, tail_beyond_attachments(model, shape.touchdown, tail));
  return shape;
}

}  // namespace overbend
