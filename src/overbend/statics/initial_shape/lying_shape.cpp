#include "statics/initial_shape/lying_shape.h"

#include <algorithm>

namespace overbend {

std::vector<double> lying_shape(const Model& model, const Line& line, const Vec3& place, const Vec3& direction,
                                double s) {
  const SeabedSurface& bed = model.seabed.surface;
  const std::vector<double>& arc_lengths = line.mesh.s;
  std::vector<Vec3> below(arc_lengths.size());  // on the bed below the nodes
  const auto step = [&](const Vec3& from, double length) -> Vec3 { return from + length * bed.along(from, direction); };
  const auto begin =
      static_cast<std::size_t>(std::lower_bound(arc_lengths.begin(), arc_lengths.end(), s) - arc_lengths.begin());
  Vec3 point = place;
  double arc = s;
  for (std::size_t node = begin; node < arc_lengths.size(); ++node) {
    point = below[node] = step(point, arc_lengths[node] - arc);
    arc = arc_lengths[node];
  }
  point = place;
  arc = s;
  for (std::size_t node = begin; node-- > 0;) {
    point = below[node] = step(point, arc_lengths[node] - arc);
    arc = arc_lengths[node];
  }
  std::vector<double> q;
  for (std::size_t node = 0; node < arc_lengths.size(); ++node) {
    const std::size_t e = std::min(node, line.mesh.length.size() - 1);
    const double weight = line.elements.weight[e] - line.elements.buoyancy[e];
    const double sunk = std::max(weight, 0.0) / line.environment.bed_stiffness;
    Vec3 on_bed = below[node];
    on_bed.z() = bed.height(on_bed.x(), on_bed.y());
    const Vec3 normal = bed.normal(on_bed.x(), on_bed.y());
    const Vec3 axis = on_bed + (line.elements.radius[e] - line.environment.bed_lowered - sunk) * normal;
    const Vec3 along = bed.along(on_bed, direction);
    q.insert(q.end(), {axis.x(), axis.y(), axis.z(), along.x(), along.y(), along.z()});
  }
  return q;
}

std::vector<double> level_shape(const Line& line, const Vec3& place, const Vec3& direction, double s) {
  std::vector<double> q;
  for (const double node : line.mesh.s) {
    const Vec3 axis = place + (node - s) * direction;
    q.insert(q.end(), {axis.x(), axis.y(), axis.z(), direction.x(), direction.y(), direction.z()});
  }
  return q;
}

}  // namespace overbend
