#include "analysis/dynamic_stations.h"

#include <algorithm>
#include <cmath>

#include "mechanics/stress.h"

namespace overbend {
namespace {

/// EI times the part of r'' across the pipe, over |a|^2: its size is EI kappa.
Vec3 bend_vector(double EI, const Vec3& a, const Vec3& b) {
  const double g = a.squaredNorm();
  return (EI / g) * (b - (a.dot(b) / g) * a);
}

struct ElementBends {
  Vec3 first, second;
};

ElementBends bends_of(const double* q, double h, double EI) {
  using Map = Eigen::Map<const Vec3>;
  const Map r1(q), t1(q + 3), r2(q + 6), t2(q + 9);
  const Vec3 chord = (6.0 / (h * h)) * (r2 - r1);
  return {bend_vector(EI, t1, chord - (4.0 / h) * t1 - (2.0 / h) * t2),
          bend_vector(EI, t2, (2.0 / h) * t1 + (4.0 / h) * t2 - chord)};
}

/// Plastic moment at a node: of the Gauss points next to it, on both sides.
Vec3 plastic_at_node(const std::vector<Vec3>& plastic_moment, std::size_t node, std::size_t last) {
  if (plastic_moment.empty()) return Vec3::Zero();
  const std::size_t after = kGaussPoints * std::min(node, last - 1);
  if (node == 0) return plastic_moment[after];
  if (node == last) return plastic_moment[after + kGaussPoints - 1];
  return 0.5 * (plastic_moment[after - 1] + plastic_moment[after]);
}

/// Inside an element: of the Gauss point that is nearest.
Vec3 plastic_inside(const std::vector<Vec3>& plastic_moment, std::size_t element, double xi) {
  if (plastic_moment.empty()) return Vec3::Zero();
  const std::size_t point = xi < 0.2 ? 0 : xi < 0.5 ? 1 : xi < 0.8 ? 2 : 3;
  return plastic_moment[kGaussPoints * element + point];
}

/// EI at a node: of the softer of its two elements, where the pipe bends more.
double softer_side(const AlignedDoubles& EI, std::size_t node, std::size_t last) {
  const double after = EI[std::min(node, last - 1)];
  return node == 0 ? after : std::min(after, EI[node - 1]);
}

double yielded_at(const std::vector<BendingMemory>& memory, std::size_t node) {
  const std::size_t after = std::min(kGaussPoints * node, memory.size() - 1);
  return std::max(memory[after].largest, after > 0 ? memory[after - 1].largest : 0.0);
}

Vec3 up_across(const Vec3& t) {
  const Vec3 up = Vec3::UnitZ() - t.z() * t;
  const double size = up.norm();
  return size > 1e-9 ? Vec3(up / size) : Vec3(Vec3::Zero());
}

}  // namespace

void NodeValues::resize(std::size_t nodes) {
  for (std::vector<double>* array : {&effective_tension, &bending_moment, &bending_stress, &von_mises, &strain,
                                     &vertical_moment, &curvature, &x, &y, &z}) {
    array->resize(nodes);
  }
}

NodeRecovery::NodeRecovery(const Model& model, const DynamicLine& line) : model_(&model), line_(&line) {
  const std::size_t nodes = static_cast<std::size_t>(line.mesh.nodes());
  for (std::size_t node = 0; node < nodes; ++node) {
    section_.push_back(line.mesh.section[std::min(node, line.mesh.section.size() - 1)]);
  }
  bend_.resize(nodes);
  tangent_.resize(nodes);
}

void NodeRecovery::bending_moments(const DynamicState& state, const std::vector<MovingContact>& contacts,
                                   const std::vector<Vec3>& plastic_moment, NodeValues& values) {
  const std::vector<double>& length = line_->mesh.length;
  std::fill(bend_.begin(), bend_.end(), Vec3(Vec3::Zero()));
  for (std::size_t e = 0; e < length.size(); ++e) {
    const ElementBends bends = bends_of(state.q.data() + 6 * e, length[e], line_->elements.EI[e]);
    bend_[e] += bends.first;
    bend_[e + 1] += bends.second;
  }
  for (const MovingContact& contact : contacts) {
    if (contact.normal > 0.0) {  // fixed-end moments of a point force on a clamped beam
      const std::size_t e = static_cast<std::size_t>(contact.at.element);
      const double x = contact.at.xi, y = 1.0 - x;
      bend_[e] += (length[e] * x * y * y) * contact.force();
      bend_[e + 1] += (length[e] * x * x * y) * contact.force();
    }
  }
  const std::size_t last = bend_.size() - 1;
  for (std::size_t node = 0; node <= last; ++node) {
    const double share = node == 0 || node == last ? 1.0 : 0.5;
    const Vec3 t = Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3)).normalized();
    const Vec3 elastic = share * (bend_[node] - bend_[node].dot(t) * t);
    const Vec3 bend = elastic - plastic_at_node(plastic_moment, node, last);
    values.curvature[node] = elastic.norm() / softer_side(line_->elements.EI, node, last);
    tangent_[node] = t;
    bend_[node] = bend;
    values.bending_moment[node] = bend.norm();
    values.vertical_moment[node] = bend.dot(up_across(t));
  }
  for (const MovingContact& contact : contacts) {
    if (contact.normal > 0.0) {
      const std::size_t e = static_cast<std::size_t>(contact.at.element);
      const double x = contact.at.xi, y = 1.0 - x;
      const ElementBends bends = bends_of(state.q.data() + 6 * e, length[e], line_->elements.EI[e]);
      const Vec3 a = Eigen::Map<const Vec3>(state.q.data() + 6 * e + 3);
      const Vec3 all = y * bends.first + x * bends.second - (2.0 * length[e] * x * x * y * y) * contact.force();
      const Vec3 elastic = all - all.dot(a) / a.squaredNorm() * a;
      const Vec3 bend = elastic - plastic_inside(plastic_moment, e, x);
      const double moment = bend.norm();
      const std::size_t node = x < 0.5 ? e : e + 1;
      values.curvature[node] = std::max(values.curvature[node], elastic.norm() / line_->elements.EI[e]);
      if (moment > values.bending_moment[node]) {
        values.bending_moment[node] = moment;
        bend_[node] = bend;
      }
    }
  }
}

void NodeRecovery::recover(const DynamicState& state, const std::vector<MovingContact>& contacts,
                           const std::vector<Vec3>& plastic_moment, NodeValues& values) {
  bending_moments(state, contacts, plastic_moment, values);
  const LineElements& elements = line_->elements;
  for (std::size_t node = 0; node < section_.size(); ++node) {
    const std::size_t e = std::min(node, line_->mesh.length.size() - 1);
    const Section& section = model_->sections[static_cast<std::size_t>(section_[node])];
    const double* q = state.q.data() + 6 * node;
    const double z = q[2];
    const double stretch = std::sqrt(q[3] * q[3] + q[4] * q[4] + q[5] * q[5]) - 1.0;
    SectionLoads loads;
    loads.effective_tension = elements.EA[e] * stretch + elements.pressure_constant[e] +
                              elements.pressure_slope[e] * z + elements.pressure_external[e] * std::max(-z, 0.0);
    loads.bending_moment = values.bending_moment[node];
    loads.curvature = values.curvature[node];
    loads.z = z;
    loads.largest_curvature = section.bending ? yielded_at(state.bending, node) : 0.0;
    loads.external_pressure = model_->water_weight_density * std::max(-z, 0.0);
    loads.internal_pressure = section.internal_pressure - section.contents_weight_density * z;
    const SectionStress stress = section_stress(section, loads);
    values.effective_tension[node] = loads.effective_tension;
    values.bending_stress[node] = stress.bending;
    values.von_mises[node] = stress.von_mises;
    values.strain[node] = stress.strain;
    values.x[node] = q[0];
    values.y[node] = q[1];
    values.z[node] = z;
  }
}

}  // namespace overbend
