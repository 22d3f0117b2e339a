#include "statics/initial_shape/lying_shape.h"

#include <algorithm>

namespace overbend {

std::vector<double> lying_shape(const Model& model, const Line& line, const Vec3& place, const Vec3& way, double s) {
  const BedSurface& bed = model.seabed.surface;
  const std::vector<double>& at = line.mesh.s;
  std::vector<Vec3> below(at.size());  // on the bed, under the nodes
  const auto step = [&](const Vec3& from, double length) -> Vec3 { return from + length * bed.along(from, way); };
  const auto begin = static_cast<std::size_t>(std::lower_bound(at.begin(), at.end(), s) - at.begin());
  Vec3 here = place;
  double arc = s;
  for (std::size_t node = begin; node < at.size(); ++node) {
    here = below[node] = step(here, at[node] - arc);
    arc = at[node];
  }
  here = place;
  arc = s;
  for (std::size_t node = begin; node-- > 0;) {
    here = below[node] = step(here, at[node] - arc);
    arc = at[node];
  }
  std::vector<double> q;
  for (std::size_t node = 0; node < at.size(); ++node) {
    const std::size_t e = std::min(node, line.mesh.length.size() - 1);
    const double weight = line.elements.weight[e] - line.elements.buoyancy[e];
    const double sunk = std::max(weight, 0.0) / line.environment.bed_stiffness;
    Vec3 on_bed = below[node];
    on_bed.z() = bed.height(on_bed.x(), on_bed.y());
    const Vec3 normal = bed.normal(on_bed.x(), on_bed.y());
    const Vec3 axis = on_bed + (line.elements.radius[e] - line.environment.bed_lowered - sunk) * normal;
    const Vec3 along = bed.along(on_bed, way);
    q.insert(q.end(), {axis.x(), axis.y(), axis.z(), along.x(), along.y(), along.z()});
  }
  return q;
}

std::vector<double> level_shape(const Line& line, const Vec3& place, const Vec3& way, double s) {
  std::vector<double> q;
  for (const double node : line.mesh.s) {
    const Vec3 axis = place + (node - s) * way;
    q.insert(q.end(), {axis.x(), axis.y(), axis.z(), way.x(), way.y(), way.z()});
  }
  return q;
}

}  // namespace overbend
