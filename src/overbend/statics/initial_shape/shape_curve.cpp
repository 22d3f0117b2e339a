#include "statics/initial_shape/shape_curve.h"

#include <algorithm>
#include <cmath>

#include "mechanics/line_elements.h"
#include "mechanics/rod_element.h"
#include "model/pipe_attachments.h"

namespace overbend {

double weight_at(const Model& model, const Section& pipe, double z) {
  return pipe.weight_in_air -
         model.water_weight_density * pipe.external_area * wetted_fraction(z, pipe.outer_radius()).value;
}

std::vector<GuidePoint> support_points(const Model& model, const LayPlane& plane, const VesselPose& pose) {
  std::vector<GuidePoint> points{{0.0, plane.tensioner_W.z(), plane.guide_dip}};
  for (const SupportRow& row : model.supports.rows) {
    const double radius = model.sections[static_cast<std::size_t>(model.section_at(row.from_top))].outer_radius();
    const SupportBox& box = model.supports.boxes[static_cast<std::size_t>(row.box)];
    const Vec3 p_W = point_from_ramp(model, pose, row.point_S + radius * box.normal_S);
    const Vec3 d_W = direction_from_ramp(pose, box.direction_S);
    const double dip = std::atan2(-d_W.z(), d_W.dot(plane.astern_W));
    points.push_back({(p_W - plane.tensioner_W).dot(plane.astern_W), p_W.z(), dip});
  }
  return points;
}

void append_point(LayShape& shape, double distance, double z, double dip) {
  if (!shape.length.empty()) {
    const double ds = std::hypot(distance - shape.distance.back(), z - shape.z.back());
    if (ds < 1e-9) {
      return;
    }
    shape.length.push_back(shape.length.back() + ds);
    if (shape.waterline < 0.0 && shape.z.back() > 0.0 && z <= 0.0) {
      shape.waterline = shape.length.back();
    }
  } else {
    shape.length.push_back(0.0);
  }
  shape.distance.push_back(distance);
  shape.z.push_back(z);
  shape.dip.push_back(dip);
}

void append_curve(LayShape& shape, const GuidePoint& to) {
  const double x0 = shape.distance.back(), z0 = shape.z.back(), dip0 = shape.dip.back();
  const double chord = std::hypot(to.distance - x0, to.z - z0);
  const int steps = std::max(2, static_cast<int>(chord / 0.25));
  for (int i = 1; i <= steps; ++i) {
    const double xi = static_cast<double>(i) / steps;
    const HermiteValues n = hermite(xi, chord);
    const auto mix = [&](const Eigen::Vector4d& w, double a, double da, double b, double db) {
      return w(0) * a + w(1) * da + w(2) * b + w(3) * db;
    };
    const double dx0 = std::cos(dip0), dz0 = -std::sin(dip0), dx1 = std::cos(to.dip), dz1 = -std::sin(to.dip);
    const double x = mix(n.value, x0, dx0, to.distance, dx1), z = mix(n.value, z0, dz0, to.z, dz1);
    const double tx = mix(n.first, x0, dx0, to.distance, dx1), tz = mix(n.first, z0, dz0, to.z, dz1);
    append_point(shape, x, z, std::atan2(-tz, tx));
  }
}

void append_tail(LayShape& shape, const LayPlane& plane, double tail) {
  const double x0 = shape.distance.back(), z0 = shape.z.back(), bed0 = plane.bed(x0);
  const double level = std::cos(std::atan(plane.bed_slope(x0)));
  const bool shaped = plane.surface.shape() != nullptr;
  constexpr double kSettling = 20.0;  // a shaped bed is reached within tens of metres [m]
  const int steps = shaped ? std::max(200, static_cast<int>(tail)) : 200;
  for (int i = 1; i <= steps; ++i) {
    const double x = x0 + tail * i / steps * level;
    const double over = (z0 - bed0) * std::exp((x0 - x) / kSettling);
    const double z = shaped ? plane.bed(x) + over : z0 + (plane.bed(x) - bed0);
    append_point(shape, x, z, -std::atan(plane.bed_slope(x)));
  }
  shape.total = shape.length.back();
}

double tail_length(const Model& model, double H, double suspended) {
  const Section& pipe = model.pipe_section();
  const double soil = std::pow(4.0 * pipe.EI / model.seabed.stiffness, 0.25);
  return 12.0 * soil + 2.0 * std::sqrt(pipe.EI / H) + std::clamp(0.25 * suspended, 30.0, 300.0);
}

double tail_beyond_attachments(const Model& model, double touchdown, double tail) {
  const std::vector<PipeAttachment> attached = pipe_attachments(model.description);
  return attached.empty() ? tail : std::max(tail, attached.back().from_top - touchdown + tail);
}

}  // namespace overbend
