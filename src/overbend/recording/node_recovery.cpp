#include "recording/node_recovery.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"
#include "mechanics/stress.h"
#include "system/cut_forces.h"

namespace overbend {
namespace {

/// EI times the component of r'' normal to the pipe over |a|^2; its magnitude is EI kappa.
Vec3 bend_vector(double EI, const Vec3& a, const Vec3& b) {
  const double g = a.squaredNorm();
  return (EI / g) * (b - (a.dot(b) / g) * a);
}

struct ElementBends {
  Vec3 first, second;
};

ElementBends element_bends(const double* q, double h, double EI) {
  using Map = Eigen::Map<const Vec3>;
  const Map r1(q), t1(q + 3), r2(q + 6), t2(q + 9);
  const Vec3 chord = (6.0 / (h * h)) * (r2 - r1);
  return {bend_vector(EI, t1, chord - (4.0 / h) * t1 - (2.0 / h) * t2),
          bend_vector(EI, t2, (2.0 / h) * t1 + (4.0 / h) * t2 - chord)};
}

/// EI at a node: that of the softer of its two elements, in which the pipe bends more.
double softer_side(const AlignedDoubles& EI, std::size_t node, std::size_t last) {
  const double after = EI[std::min(node, last - 1)];
  return node == 0 ? after : std::min(after, EI[node - 1]);
}

/// Section in which the stresses of a node are evaluated.
int section_at(const Model& model, const LineMesh& mesh, std::size_t node) {
  const int after = mesh.section[std::min(node, mesh.section.size() - 1)];
  const int before = mesh.section[node == 0 ? 0 : node - 1];
  const Section& upper = model.sections[static_cast<std::size_t>(after)];
  const Section& lower = model.sections[static_cast<std::size_t>(before)];
  return reports_lower_section(lower, upper) ? before : after;
}

double max_curvature_at(const BendingMemories& memory, std::size_t node) {
  const std::size_t after = std::min(kGaussPoints * node, memory.size() - 1);
  return std::max(memory.max_curvature(after), after > 0 ? memory.max_curvature(after - 1) : 0.0);
}

/// Removes the component of a moment about the pipe's axis and turns it towards the centre of curvature.
Vec3 bend_towards_centre(const Vec3& moment, const Vec3& t) {
  return (moment - moment.dot(t) * t).cross(t);
}

Vec3 node_position(const LineState& state, std::size_t node) {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node));
}

Vec3 node_tangent(const LineState& state, std::size_t node) {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3));
}

RecoverKernel recover_kernel() {
#if defined(OVERBEND_X86_KERNELS)
  if (best_isa() == Isa::avx512) return isa_avx512::recover_nodes;
  if (best_isa() == Isa::avx2) return isa_avx2::recover_nodes;
#endif
  return isa_baseline::recover_nodes;
}

}  // namespace

void NodeValues::resize(std::size_t nodes) {
  for (std::vector<double>* array : {&effective_tension, &bending_moment, &bending_stress, &von_mises, &strain,
                                     &vertical_moment, &curvature, &external_pressure, &x, &y, &z}) {
    array->resize(nodes);
  }
}

NodeRecovery::NodeRecovery(const Model& model, const Line& line)
    : model_(&model), line_(&line), recover_(recover_kernel()) {
  const std::size_t nodes = static_cast<std::size_t>(line.mesh.nodes());
  for (std::size_t node = 0; node < nodes; ++node) {
    section_.push_back(section_at(model, line.mesh, node));
  }
  find_section_runs(section_, runs_);
  for (VectorColumns* columns : {&bend_, &tangent_}) columns->resize(nodes);
  carrying_.reserve(model.supports.rollers.size());
}

/// Copies positions, tangents and the tensions and moments of the cuts.
void NodeRecovery::take_cuts(const LineState& state, const std::vector<double>& cuts, NodeValues& values) {
  const RecoveredNodes out{values.x.data(),
                           values.y.data(),
                           values.z.data(),
                           {tangent_.x.data(), tangent_.y.data(), tangent_.z.data()},
                           {bend_.x.data(), bend_.y.data(), bend_.z.data()},
                           values.effective_tension.data(),
                           values.bending_moment.data(),
                           values.vertical_moment.data()};
  recover_(NodeRows{state.q.data(), cuts.data()}, static_cast<int>(section_.size()), out);
}

// The loops have non-overlapping arrays (declared to the compiler) and no branches, so that they are vectorised.

void NodeRecovery::find_pressures(const std::vector<double>& water, NodeValues& values) const {
  const double* z = values.z.data();
  double* pressure = values.external_pressure.data();
  const std::size_t nodes = section_.size();
  const double density = model_->water_weight_density;
  const double* head = water.empty() ? nullptr : water.data() + 7;
#pragma GCC ivdep
  for (std::size_t node = 0; node < nodes; ++node) {
    const double surface = head != nullptr ? head[static_cast<std::size_t>(kWaterValues) * node] : 0.0;
    pressure[node] = density * std::max(surface - z[node], 0.0);
  }
}

/// Curvatures of linear steel.
void NodeRecovery::linear_curvatures(const SectionRun& run, NodeValues& values) const {
  const double per_EI = 1.0 / model_->sections[run.section].EI;
  const double* moment = values.bending_moment.data();
  double* curvature = values.curvature.data();
#pragma GCC ivdep
  for (std::size_t node = run.first; node < run.last; ++node) curvature[node] = moment[node] * per_EI;
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
      const ElementBends bends = element_bends(state.q.data() + 6 * e, length[e], line_->elements.EI[e]);
      bend += upper ? bends.second : bends.first;
      for (const RollerContact* contact : carrying_) {
        if (static_cast<std::size_t>(contact->closest.element) == e) {
          const double x = contact->closest.xi, y = 1.0 - x;
          bend += (length[e] * x * y * (upper ? x : y)) * contact->force();
        }
      }
    };
    if (node > 0) add_element(node - 1, true);
    if (node < last) add_element(node, false);
    const double share = node == 0 || node == last ? 1.0 : 0.5;
    const Vec3 t = tangent_[node];
    values.curvature[node] = share * (bend - bend.dot(t) * t).norm() / softer_side(line_->elements.EI, node, last);
  }
}

/// Balance of the part of the element below the roller: the cut at its lower node, the rollers on it, the cut under
/// this roller and the distributed load, uniform as given by the cuts at its ends.
Vec3 NodeRecovery::moment_under(const LineState& state, const LineAssembly& line, const RollerContact& contact) const {
  const std::size_t e = static_cast<std::size_t>(contact.closest.element);
  const double h = line_->mesh.length[e], x = contact.closest.xi;
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
  const CentrelinePoint point = centreline(q, x, h);
  const Vec3 below = cut_at_node(line.cuts(), state.q, e).force;
  Vec3 spread = below - cut_at_node(line.cuts(), state.q, e + 1).force;
  Vec3 moment = cut_at_node(line.cuts(), state.q, e).moment - (point.r - node_position(state, e)).cross(below);
  for (const RollerContact* neighbour : carrying_) {
    if (neighbour->closest.element != contact.closest.element) continue;
    spread -= neighbour->force();
    if (neighbour->closest.xi < x) {
      moment -= (centreline(q, neighbour->closest.xi, h).r - point.r).cross(neighbour->force());
    }
  }
  moment -= (centreline(q, 0.5 * x, h).r - point.r).cross(x * spread);
  return bend_towards_centre(moment, point.a.normalized());
}

/// EI times the curvature under a roller.
Vec3 NodeRecovery::shape_bend(const LineState& state, const RollerContact& contact) const {
  const std::size_t e = static_cast<std::size_t>(contact.closest.element);
  const double h = line_->mesh.length[e], x = contact.closest.xi, y = 1.0 - x;
  const ElementBends bends = element_bends(state.q.data() + 6 * e, h, line_->elements.EI[e]);
  const Vec3 a = node_tangent(state, e);
  const Vec3 all = y * bends.first + x * bends.second - (2.0 * h * x * x * y * y) * contact.force();
  return all - all.dot(a) / a.squaredNorm() * a;
}

void NodeRecovery::moments_under_rollers(const LineState& state, const LineAssembly& line, NodeValues& values) {
  for (const RollerContact* contact : carrying_) {
    const std::size_t e = static_cast<std::size_t>(contact->closest.element);
    const std::size_t node = contact->closest.xi < 0.5 ? e : e + 1;
    const Section& section = model_->sections[static_cast<std::size_t>(line_->mesh.section[e])];
    const Vec3 bend = moment_under(state, line, *contact);
    const double moment = bend.norm();
    const double curvature =
        section.bending ? shape_bend(state, *contact).norm() / line_->elements.EI[e] : moment / section.EI;
    values.curvature[node] = std::max(values.curvature[node], curvature);
    if (moment > values.bending_moment[node]) {
      values.bending_moment[node] = moment;
      bend_.set(node, bend);
    }
  }
}

/// A cable has no bending; the stabilising stiffness of a slack cable is not reported.
void NodeRecovery::set_without_bending(const SectionRun& run, NodeValues& values) {
  for (std::size_t node = run.first; node < run.last; ++node) {
    bend_.set(node, Vec3::Zero());
    values.bending_moment[node] = values.vertical_moment[node] = values.curvature[node] = 0.0;
    values.bending_stress[node] = values.von_mises[node] = values.strain[node] = 0.0;
  }
}

void NodeRecovery::elastic_stresses(const SectionRun& run, NodeValues& values) const {
  const Section& section = model_->sections[run.section];
  const SectionWall wall(section);
  const double at_zero = section.internal_pressure, by_height = section.contents_weight_density;
  const double* tension = values.effective_tension.data();
  const double* moment = values.bending_moment.data();
  const double* curvature = values.curvature.data();
  const double* external = values.external_pressure.data();
  const double* z = values.z.data();
  double* bending = values.bending_stress.data();
  double* von_mises = values.von_mises.data();
  double* strain = values.strain.data();
#pragma GCC ivdep
  for (std::size_t node = run.first; node < run.last; ++node) {
    SectionLoads loads;
    loads.effective_tension = tension[node];
    loads.bending_moment = moment[node];
    loads.curvature = curvature[node];
    loads.external_pressure = external[node];
    loads.internal_pressure = at_zero - by_height * z[node];
    const SectionStress stress = stress_of_wall(wall, loads, 0.0, [](double elastic, double) { return elastic; });
    bending[node] = stress.bending;
    von_mises[node] = stress.von_mises;
    strain[node] = stress.strain;
  }
}

void NodeRecovery::yielding_stresses(const SectionRun& run, const LineState& state, NodeValues& values) const {
  const Section& section = model_->sections[run.section];
  for (std::size_t node = run.first; node < run.last; ++node) {
    SectionLoads loads;
    loads.effective_tension = values.effective_tension[node];
    loads.bending_moment = values.bending_moment[node];
    loads.curvature = values.curvature[node];
    loads.z = values.z[node];
    loads.max_curvature = max_curvature_at(state.bending, node);
    loads.external_pressure = values.external_pressure[node];
    loads.internal_pressure = section.internal_pressure - section.contents_weight_density * loads.z;
    const SectionStress stress = section_stress(section, loads);
    values.bending_stress[node] = stress.bending;
    values.von_mises[node] = stress.von_mises;
    values.strain[node] = stress.strain;
  }
}

void NodeRecovery::recover(const LineState& state, const LineAssembly& line, const std::vector<double>& water,
                           NodeValues& values) {
  carrying_.clear();
  for (const RollerContact& contact : line.contacts().contacts()) {
    if (contact.normal > 0.0) carrying_.push_back(&contact);
  }
  take_cuts(state, line.cuts(), values);
  find_pressures(water, values);
  for (const SectionRun& run : runs_) linear_curvatures(run, values);
  if (line_->yielding.any) shape_curvatures(state, values);
  moments_under_rollers(state, line, values);
  for (const SectionRun& run : runs_) {
    const Section& section = model_->sections[run.section];
    if (section.kind == SectionKind::cable) {
      set_without_bending(run, values);  // a cable has tension only
    } else if (section.bending) {
      yielding_stresses(run, state, values);
    } else {
      elastic_stresses(run, values);
    }
  }
}

}  // namespace overbend
