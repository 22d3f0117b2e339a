#include "system/yielding.h"

#include <algorithm>
#include <numeric>

#include "system/yielding_element.h"

namespace overbend {

YieldingElements yielding_elements(const Model& model, const LineMesh& mesh) {
  YieldingElements elements;
  for (const int section : mesh.section) {
    const Section& of = model.sections[static_cast<std::size_t>(section)];
    elements.law.push_back(of.bending ? &*of.bending : nullptr);
    elements.any = elements.any || of.bending;
    elements.linear_pipe.push_back(!of.bending && of.kind == SectionKind::pipe);
  }
  elements.mix.resize(mesh.section.size());
  return elements;
}

void choose_levels(YieldingElements& elements, const double* q) {
  for (std::size_t e = 0; e < elements.law.size(); ++e) {
    if (elements.law[e] != nullptr) {
      elements.mix[e] = level_at(*elements.law[e], 0.5 * (q[6 * e + 2] + q[6 * e + 8]));
    }
  }
}

std::vector<BendingMemory> fresh_memories(const LineMesh& mesh, const double* q) {
  std::vector<BendingMemory> memories;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const ElementVector at_nodes = dofs({q, nullptr}, e);
    for (int i = 0; i < kGaussPoints; ++i) {
      memories.push_back(make_bending_memory(point_at(at_nodes, gauss_shape(i, mesh.length[e])).a.normalized()));
    }
  }
  return memories;
}

MovingYielding::MovingYielding(const YieldingElements& elements, const LineMesh& mesh)
    : elements_(&elements), mesh_(&mesh), padded_((elements.law.size() + kLanes - 1) / kLanes * kLanes) {
  if (!elements.any) return;
  left_.resize(kGaussPoints * padded_, 0.0);
  stored_held_.resize(kLanes, 0.0);
  slid_.reserve(kGaussPoints * elements.law.size());
  has_slid_.resize(kGaussPoints * elements.law.size());
}

void MovingYielding::begin(const BendingMemories& before, BendingMemories& after) {
  forget_slid();
  if (!fitted_.empty()) fitted_ = {};
  after.assign_from(before);
  for (std::size_t point = 0; point < before.size(); ++point) {
    const BendingLaw* law = elements_->law[point / kGaussPoints];
    const LevelMix& mix = elements_->mix[point / kGaussPoints];
    if (law == nullptr ? !before.has_slid(point) : before.mix(point) == mix) continue;
    if (fitted_.empty()) fitted_ = before;
    BendingMemory memory = before.at(point);
    if (law == nullptr) {
      memory = make_bending_memory(memory.tangent);
    } else {
      update_held_moment(*law, mix, memory);
    }
    fitted_.set(point, memory);
  }
  if (!fitted_.empty()) after.assign_from(fitted_);
}

HeldSections MovingYielding::held(const BendingMemories& before, BendingMemories& after) {
  std::fill(stored_held_.begin(), stored_held_.end(), 0.0);
  return {start(before).held(), after.held(), left_.data(), stored_held_.data()};
}

double MovingYielding::add_sliding(const double* q, const BendingMemories& before, BendingMemories& after,
                                   const YieldingTarget& target) {
  double loss = 0.0;
  stored_sliding_ = 0.0;
  for (std::size_t e = 0; e < elements_->law.size(); ++e) {
    const double* any = left_.data() + e;
    if (elements_->law[e] == nullptr || any[0] + any[padded_] + any[2 * padded_] + any[3 * padded_] == 0.0) continue;
    const ElementVector at_nodes = dofs({q, nullptr}, e);
    ElementSum sum(target.tangent != nullptr);
    for (int i = 0; i < kGaussPoints; ++i) {
      const std::size_t point = kGaussPoints * e + static_cast<std::size_t>(i);
      if (left(point) == 0.0) continue;
      const HermiteValues shape = gauss_shape(i, mesh_->length[e]);
      const CentrelinePoint centre_point = point_at(at_nodes, shape);
      BendingMemory memory = start(before).at(point);
      transport_axes(memory, centre_point.a.normalized());
      const Vec2 k = in_axes(memory, curvature_vector(centre_point));
      const BendingResponse answer = bend(*elements_->law[e], elements_->mix[e], k, memory);
      after.set(point, memory);
      if (!has_slid_[point]) slid_.push_back(point);
      has_slid_[point] = true;
      const double weight = kGaussWeight[i] * mesh_->length[e];
      loss += weight * answer.loss;
      stored_sliding_ += weight * stored_beyond_elastic(k, memory);
      Vec3 moment;
      sum.add(shape, centre_point, weight, memory, answer, moment);
    }
    sum.scatter_to(static_cast<int>(e), target);
  }
  return loss;
}

double MovingYielding::stored() const {
  return std::accumulate(stored_held_.begin(), stored_held_.end(), stored_sliding_);
}

void MovingYielding::finish(const BendingMemories& before, BendingMemories& after) {
  for (const std::size_t point : slid_) {
    if (left(point) != 0.0) continue;
    BendingMemory memory = start(before).at(point);
    const BendingMemory carried = after.at(point);  // by the kernel
    memory.tangent = carried.tangent;
    memory.axis = carried.axis;
    after.set(point, memory);
  }
  forget_slid();
}

void MovingYielding::forget_slid() {
  for (const std::size_t point : slid_) has_slid_[point] = false;
  slid_.clear();
}

}  // namespace overbend
