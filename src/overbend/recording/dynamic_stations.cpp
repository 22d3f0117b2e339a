#include "recording/dynamic_stations.h"

#include <algorithm>
#include <cmath>

#include "mechanics/stress.h"
#include "system/cut_forces.h"

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

/// Part of a moment about the pipe's axis taken off, and turned to point to the centre of the curve.
Vec3 bend_of(const Vec3& moment, const Vec3& t) {
  return (moment - moment.dot(t) * t).cross(t);
}

Vec3 place_of(const LineState& state, std::size_t node) {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node));
}

Vec3 tangent_of(const LineState& state, std::size_t node) {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3));
}

}  // namespace

void NodeValues::resize(std::size_t nodes) {
  for (std::vector<double>* array : {&effective_tension, &bending_moment, &bending_stress, &von_mises, &strain,
                                     &vertical_moment, &curvature, &external_pressure, &x, &y, &z}) {
    array->resize(nodes);
  }
}

NodeRecovery::NodeRecovery(const Model& model, const Line& line) : model_(&model), line_(&line) {
  const std::size_t nodes = static_cast<std::size_t>(line.mesh.nodes());
  for (std::size_t node = 0; node < nodes; ++node) {
    section_.push_back(line.mesh.section[std::min(node, line.mesh.section.size() - 1)]);
  }
  bend_.resize(nodes);
  tangent_.resize(nodes);
  carrying_.reserve(model.supports.rollers.size());
}

void NodeRecovery::cut_moments(const LineState& state, const std::vector<double>& cuts, NodeValues& values) {
  for (std::size_t node = 0; node < bend_.size(); ++node) {
    const Vec3 t = tangent_of(state, node).normalized();
    tangent_[node] = t;
    const CutForces cut = cut_at_node(cuts, state.q, node);
    bend_[node] = bend_of(cut.moment, t);
    values.effective_tension[node] = cut.force.dot(t);
    values.bending_moment[node] = bend_[node].norm();
    values.vertical_moment[node] = bend_[node].dot(up_across(t));
    values.curvature[node] =
        values.bending_moment[node] / model_->sections[static_cast<std::size_t>(section_[node])].EI;
  }
}

/// EI times the curvature at a node is the mean of those of the cubics on both sides, with the fixed-end moments of the
/// roller forces inside the elements added: exact for small bending between nodes.
void NodeRecovery::shape_curvatures(const LineState& state, NodeValues& values) {
  const std::vector<double>& length = line_->mesh.length;
  const std::size_t last = length.size();
  for (std::size_t node = 0; node <= last; ++node) {
    if (!model_->sections[static_cast<std::size_t>(section_[node])].bending) continue;
    Vec3 bend = Vec3::Zero();
    const auto add_element = [&](std::size_t e, bool upper) {
      const ElementBends bends = bends_of(state.q.data() + 6 * e, length[e], line_->elements.EI[e]);
      bend += upper ? bends.second : bends.first;
      for (const RollerContact* contact : carrying_) {
        if (static_cast<std::size_t>(contact->at.element) == e) {
          const double x = contact->at.xi, y = 1.0 - x;
          bend += (length[e] * x * y * (upper ? x : y)) * contact->force();
        }
      }
    };
    if (node > 0) add_element(node - 1, true);
    if (node < last) add_element(node, false);
    const double share = node == 0 || node == last ? 1.0 : 0.5;
    const Vec3& t = tangent_[node];
    values.curvature[node] = share * (bend - bend.dot(t) * t).norm() / softer_side(line_->elements.EI, node, last);
  }
}

/// The part of the element below the roller is in balance under the cut at its lower node, the rollers on it, the cut
/// under this roller and what is spread along the element, evenly as far as the cuts at its ends tell.
Vec3 NodeRecovery::moment_under(const LineState& state, const LineAssembly& line, const RollerContact& contact) const {
  const std::size_t e = static_cast<std::size_t>(contact.at.element);
  const double h = line_->mesh.length[e], x = contact.at.xi;
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
  const CentrelinePoint here = centreline(q, x, h);
  const Vec3 below = cut_at_node(line.cuts(), state.q, e).force;
  Vec3 spread = below - cut_at_node(line.cuts(), state.q, e + 1).force;
  Vec3 moment = cut_at_node(line.cuts(), state.q, e).moment - (here.r - place_of(state, e)).cross(below);
  for (const RollerContact* other : carrying_) {
    if (other->at.element != contact.at.element) continue;
    spread -= other->force();
    if (other->at.xi < x) moment -= (centreline(q, other->at.xi, h).r - here.r).cross(other->force());
  }
  moment -= (centreline(q, 0.5 * x, h).r - here.r).cross(x * spread);
  return bend_of(moment, here.a.normalized());
}

/// EI times the curvature under a roller.
Vec3 NodeRecovery::shape_bend(const LineState& state, const RollerContact& contact) const {
  const std::size_t e = static_cast<std::size_t>(contact.at.element);
  const double h = line_->mesh.length[e], x = contact.at.xi, y = 1.0 - x;
  const ElementBends bends = bends_of(state.q.data() + 6 * e, h, line_->elements.EI[e]);
  const Vec3 a = tangent_of(state, e);
  const Vec3 all = y * bends.first + x * bends.second - (2.0 * h * x * x * y * y) * contact.force();
  return all - all.dot(a) / a.squaredNorm() * a;
}

void NodeRecovery::moments_under_rollers(const LineState& state, const LineAssembly& line, NodeValues& values) {
  for (const RollerContact* contact : carrying_) {
    const std::size_t e = static_cast<std::size_t>(contact->at.element);
    const std::size_t node = contact->at.xi < 0.5 ? e : e + 1;
    const Section& section = model_->sections[static_cast<std::size_t>(line_->mesh.section[e])];
    const Vec3 bend = moment_under(state, line, *contact);
    const double moment = bend.norm();
    const double curvature =
        section.bending ? shape_bend(state, *contact).norm() / line_->elements.EI[e] : moment / section.EI;
    values.curvature[node] = std::max(values.curvature[node], curvature);
    if (moment > values.bending_moment[node]) {
      values.bending_moment[node] = moment;
      bend_[node] = bend;
    }
  }
}

/// A cable has no bending; what keeps it defined where it is slack is not told.
void NodeRecovery::lay_straight(std::size_t node, NodeValues& values) {
  bend_[node] = Vec3::Zero();
  values.bending_moment[node] = values.vertical_moment[node] = values.curvature[node] = 0.0;
}

void NodeRecovery::recover(const LineState& state, const LineAssembly& line, const std::vector<double>& water,
                           NodeValues& values) {
  carrying_.clear();
  for (const RollerContact& contact : line.contacts().contacts()) {
    if (contact.normal > 0.0) carrying_.push_back(&contact);
  }
  cut_moments(state, line.cuts(), values);
  if (line_->yielding.any) shape_curvatures(state, values);
  moments_under_rollers(state, line, values);
  for (std::size_t node = 0; node < section_.size(); ++node) {
    const Section& section = model_->sections[static_cast<std::size_t>(section_[node])];
    if (section.kind == SectionKind::cable) lay_straight(node, values);
    const double* q = state.q.data() + 6 * node;
    const double z = q[2];
    const double head = water.empty() ? 0.0 : water[static_cast<std::size_t>(kWaterValues) * node + 7];
    SectionLoads loads;
    loads.effective_tension = values.effective_tension[node];
    loads.bending_moment = values.bending_moment[node];
    loads.curvature = values.curvature[node];
    loads.z = z;
    loads.largest_curvature = section.bending ? yielded_at(state.bending, node) : 0.0;
    loads.external_pressure = model_->water_weight_density * std::max(head - z, 0.0);
    loads.internal_pressure = section.internal_pressure - section.contents_weight_density * z;
    const SectionStress stress = section_stress(section, loads);
    values.external_pressure[node] = loads.external_pressure;
    const bool pipe = section.kind != SectionKind::cable;  // what is told of a cable is its tension
    values.bending_stress[node] = pipe ? stress.bending : 0.0;
    values.von_mises[node] = pipe ? stress.von_mises : 0.0;
    values.strain[node] = pipe ? stress.strain : 0.0;
    values.x[node] = q[0];
    values.y[node] = q[1];
    values.z[node] = z;
  }
}

}  // namespace overbend
