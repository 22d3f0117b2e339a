/// Plastic bending history of a line's Gauss points in the memory layout of the element kernel.
#pragma once

#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "mechanics/line_kernel.h"
#include "mechanics/plastic_bending.h"
#include "mechanics/quadrature.h"

namespace overbend {

/// Whole elements with kGaussPoints each; points are numbered along the line. Section values read in every step are
/// stored separately from the slips, which are many and rarely read.
class BendingMemories {
 public:
  BendingMemories() = default;
  explicit BendingMemories(const std::vector<BendingMemory>& points);

  bool empty() const { return stamp_.empty(); }
  std::size_t size() const { return stamp_.size(); }
  BendingMemory at(std::size_t point) const;
  void set(std::size_t point, const BendingMemory& memory);
  std::vector<BendingMemory> all() const;

  double max_curvature(std::size_t point) const { return max_curvature_[point]; }
  const LevelMix& mix(std::size_t point) const { return mix_[point]; }
  bool has_slid(std::size_t point) const { return stamp_[point] != 0; }
  /// Values kHeldValues by Gauss point, number and element (padded count), as in HeldSections.
  const double* held() const { return held_.data(); }
  double* held() { return held_.data(); }

  /// Copies `source`, which must have the same size. Slips with equal stamps are not copied.
  void assign_from(const BendingMemories& source);

 private:
  double& held(std::size_t point, int number) { return held_[place(point, number)]; }
  double held(std::size_t point, int number) const { return held_[place(point, number)]; }
  std::size_t place(std::size_t point, int number) const {
    return (kHeldValues * (point % kGaussPoints) + static_cast<std::size_t>(number)) * padded_ + point / kGaussPoints;
  }

  std::size_t padded_ = 0;
  AlignedDoubles held_;
  std::vector<double> max_curvature_;
  std::vector<LevelMix> mix_;
  std::vector<std::uint64_t> stamp_;
  std::vector<Slips> slips_;
};

}  // namespace overbend
