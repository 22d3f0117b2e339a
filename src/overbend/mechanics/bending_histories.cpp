#include "mechanics/bending_histories.h"

#include "base/require.h"

namespace overbend {

BendingMemories::BendingMemories(const std::vector<BendingMemory>& points)
    : padded_((points.size() / kGaussPoints + kLanes - 1) / kLanes * kLanes),
      held_(kGaussPoints * kHeldValues * padded_, 0.0),
      max_curvature_(points.size()),
      mix_(points.size()),
      stamp_(points.size()),
      slips_(points.size()) {
  require(points.size() % kGaussPoints == 0, "memories cover whole elements");
  for (std::size_t point = 0; point < points.size(); ++point) set(point, points[point]);
}

BendingMemory BendingMemories::at(std::size_t point) const {
  BendingMemory memory;
  for (int c = 0; c < 3; ++c) {
    memory.tangent(c) = held(point, kHeldTangent + c);
    memory.axis(c) = held(point, kHeldAxis + c);
  }
  memory.center = {held(point, kHeldCenter), held(point, kHeldCenter + 1)};
  memory.slack = held(point, kHeldSlack);
  memory.held = {held(point, kHeldMoment), held(point, kHeldMoment + 1)};
  memory.stored = held(point, kHeldStored);
  memory.max_curvature = max_curvature_[point];
  memory.held_mix = mix_[point];
  memory.stamp = stamp_[point];
  memory.slip = slips_[point];
  return memory;
}

void BendingMemories::set(std::size_t point, const BendingMemory& memory) {
  for (int c = 0; c < 3; ++c) {
    held(point, kHeldTangent + c) = memory.tangent(c);
    held(point, kHeldAxis + c) = memory.axis(c);
  }
  held(point, kHeldCenter) = memory.center.x();
  held(point, kHeldCenter + 1) = memory.center.y();
  held(point, kHeldSlack) = memory.slack;
  held(point, kHeldMoment) = memory.held.x();
  held(point, kHeldMoment + 1) = memory.held.y();
  held(point, kHeldStored) = memory.stored;
  max_curvature_[point] = memory.max_curvature;
  mix_[point] = memory.held_mix;
  stamp_[point] = memory.stamp;
  slips_[point] = memory.slip;
}

std::vector<BendingMemory> BendingMemories::all() const {
  std::vector<BendingMemory> points;
  points.reserve(size());
  for (std::size_t point = 0; point < size(); ++point) points.push_back(at(point));
  return points;
}

void BendingMemories::assign_from(const BendingMemories& source) {
  held_ = source.held_;
  max_curvature_ = source.max_curvature_;
  mix_ = source.mix_;
  for (std::size_t point = 0; point < size(); ++point) {
    if (stamp_[point] != source.stamp_[point]) slips_[point] = source.slips_[point];
  }
  stamp_ = source.stamp_;
}

}  // namespace overbend
