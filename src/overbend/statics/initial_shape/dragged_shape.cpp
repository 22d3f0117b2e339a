#include "statics/initial_shape/dragged_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "mechanics/element_constants.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/shape_curve.h"

namespace overbend {
namespace {

constexpr double kBedStep = 1.0;      ///< Step along the bed [m].
constexpr double kGuessError = 0.05;  ///< Possible error of the initial shape relative to the tension at the tensioner.

/// Integrates the line along the bed and up to the winch.
class DraggedLineIntegrator {
 public:
  DraggedLineIntegrator(const Model& model, const LayPlane& plane, double top, LayShape landed)
      : model_(model),
        plane_(plane),
        shape_(std::move(landed)),
        tension_(shape_.bottom_tension),
        min_tension_(tension_),
        min_tension_place_(shape_.touchdown),
        top_(top) {
    const Vec3 winch = winch_place(model, plane);
    end_ = (winch - plane.tensioner_W).dot(plane.astern_W);
    end_z_ = winch.z();
    for (const Section& section : model.sections) drag_.push_back(pipe_constants(model, section).drag_on_bed);
  }

  LayShape run() {
    while (length() < pipe_end() && distance() < end_) advance_on_bed();
    if (distance() >= end_) return failed(passed_winch());
    while (distance() + kBedStep < end_ && tension_ > 0.0 && rises_above_winch()) advance_on_bed();
    shape_.edges.push_back(length());
    if (min_tension_ < 0.0) return failed(compression());
    if (min_tension_ < kGuessError * top_) shape_.error = compression();  // the initial shape is that uncertain
    rise_to_winch();
    shape_.total = shape_.length.back();
    shape_.far_force = tension_ * std::cos(slope());
    return std::move(shape_);
  }

 private:
  double length() const { return shape_.length.back(); }
  double distance() const { return shape_.distance.back(); }
  double pipe_end() const {
    return pipe_end_distance(model_.description) + model_.description.operation.lay.head->length;
  }
  double slope() const { return std::atan(plane_.bed_slope(distance())); }
  int section_index(double from_top) const { return model_.section_at(from_top); }
  const Section& section(double from_top) const {
    return model_.sections[static_cast<std::size_t>(section_index(from_top))];
  }

  /// Appends a point; its length is unstressed.
  void append(double x, double z, double dip) {
    const double before = length(), EA = section(before).EA;
    append_point(shape_, x, z, dip);
    shape_.length.back() = before + (shape_.length.back() - before) / (1.0 + tension_ / EA);
  }

  /// Advances one step along the bed; friction and slope increase the tension.
  void advance_on_bed() {
    const double u = length() + 0.5 * kBedStep, a = slope();
    const Section& lying = section(u);
    const double next = distance() + kBedStep * std::cos(a), turn = std::atan(plane_.bed_slope(next)) - a;
    const double weight = weight_at(model_, lying, shape_.z.back());
    const double normal = std::max(0.0, weight * std::cos(a) - tension_ * turn / kBedStep);
    const double drag = drag_[static_cast<std::size_t>(section_index(u))];
    tension_ += kBedStep * (weight * std::sin(a) - drag * normal);
    if (tension_ < min_tension_) {
      min_tension_ = tension_;
      min_tension_place_ = u;
    }
    const double sunk = std::max(0.0, weight) / model_.seabed.stiffness;
    append(next, plane_.bed(next) - plane_.radius + lying.outer_radius() - sunk, -std::atan(plane_.bed_slope(next)));
  }

  /// True if a cable that leaves the bed here, tangentially, reaches its winch from above.
  bool rises_above_winch() const {
    const double X = end_ - distance(), H = std::max(tension_, 1.0) * std::cos(slope());
    const double rise = X * std::tan(slope()) + 0.5 * cable_weight() * X * X / H;
    return shape_.z.back() + rise > end_z_;
  }

  /// Weight of the cable half way up to its winch [N/m].
  double cable_weight() const { return weight_at(model_, section(pipe_end() + 1.0), 0.5 * (shape_.z.back() + end_z_)); }

  void rise_to_winch() {
    constexpr int kPoints = 200;
    const double x0 = distance(), z0 = shape_.z.back(), X = end_ - x0, tangent = std::tan(slope());
    const double bend = (end_z_ - z0 - tangent * X) / (X * X);
    for (int i = 1; i <= kPoints; ++i) {
      const double x = X * i / kPoints;
      append(x0 + x, z0 + tangent * x + bend * x * x, -std::atan(tangent + 2.0 * bend * x));
    }
  }

  ShapeError compression() const {
    return {"the line is in compression", shown(min_tension_place_, "m", 1) + " from the tensioner",
            dragging_direction(model_.description) > 0.0
                ? "seabed friction does not hold it on the slope: increase the tension at the tensioner"
                : "seabed friction consumes the tension before the winch: increase the tension at the tensioner, or "
                  "pay out less pipe"};
  }

  ShapeError passed_winch() const {
    return {
        "the pipe has passed the winch", "at the winch",
        fmt::format("{} of pipe with its head of {} extend beyond the winch, {} from the tensioner: pull less pipe or "
                    "give a larger operation.winch.distance",
                    shown_digits(pipe_end_distance(model_.description), "m", 6),
                    shown_digits(model_.description.operation.lay.head->length, "m", 4), shown_digits(end_, "m", 6))};
  }

  LayShape failed(ShapeError error) {
    shape_.problem = error.why;
    shape_.error = std::move(error);
    return std::move(shape_);
  }

  const Model& model_;
  const LayPlane& plane_;
  LayShape shape_;
  double tension_;
  double min_tension_,
      min_tension_place_ = 0.0;  ///< Minimum tension on the bed, and its length from the tensioner [N], [m].
  double top_;                   ///< Tension at the tensioner [N].
  double end_ = 0.0, end_z_ = 0.0;
  std::vector<double> drag_;  ///< Per section, positive away from the vessel [-].
};

/// Initial shape of a lay, down to the touchdown point.
LayShape cut_at_touchdown(LayShape shape) {
  const auto end = ranges::lower_bound(shape.length, shape.touchdown - 1e-9) - shape.length.begin() + 1;
  for (std::vector<double>* values : {&shape.length, &shape.distance, &shape.z, &shape.dip}) {
    values->resize(static_cast<std::size_t>(end));
  }
  return shape;
}

}  // namespace

Vec3 winch_place(const Model& model, const LayPlane& plane) {
  const WinchPlace& winch = *model.description.operation.lay.winch;
  const Vec3 shoe = point_from_ramp(model, model.mean_pose, Vec3::Zero());
  const double along = winch.distance - (plane.tensioner_W - shoe).dot(plane.astern_W);
  Vec3 place = plane.tensioner_W + along * plane.astern_W;
  place.z() = -winch.depth;
  return place;
}

LayShape dragged_shape(const Model& model, const LayPlane& plane, double tension, LayShape landed) {
  const double end = pipe_end_distance(model.description) + model.description.operation.lay.head->length;
  LayShape stiff = lay_shape(model, plane, tension);
  if (stiff.problem.empty() && stiff.touchdown < end) landed = cut_at_touchdown(std::move(stiff));
  return DraggedLineIntegrator(model, plane, tension, std::move(landed)).run();
}

}  // namespace overbend
