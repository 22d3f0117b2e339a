/// The memories of a line's Gauss points, laid out as the element kernel reads them.
#pragma once

#include <vector>

#include "base/aligned.h"
#include "base/simd.h"
#include "mechanics/line_kernel.h"
#include "mechanics/plastic_bending.h"
#include "mechanics/quadrature.h"

namespace overbend {

/// Of whole elements, kGaussPoints each; a point is counted along the line. What a section holds stands apart from its
/// slips, which are many and seldom looked at.
class BendingMemories {
 public:
  BendingMemories() = default;
  explicit BendingMemories(const std::vector<BendingMemory>& points);

  bool empty() const { return stamp_.empty(); }
  std::size_t size() const { return stamp_.size(); }
  BendingMemory at(std::size_t point) const;
  void set(std::size_t point, const BendingMemory& memory);
  std::vector<BendingMemory> all() const;

  double largest(std::size_t point) const { return largest_[point]; }
  const LevelMix& mix(std::size_t point) const { return mix_[point]; }
  bool has_slid(std::size_t point) const { return stamp_[point] != 0; }
  /// kHeldValues by Gauss point, number and element (padded count), as HeldSections.
  const double* held() const { return held_.data(); }
  double* held() { return held_.data(); }

  /// Becomes what `other`, of the same size, is. Slips that are the same already are left alone: stamps tell.
  void become(const BendingMemories& other);

 private:
  double& held(std::size_t point, int number) { return held_[place(point, number)]; }
  double held(std::size_t point, int number) const { return held_[place(point, number)]; }
  std::size_t place(std::size_t point, int number) const {
    return (kHeldValues * (point % kGaussPoints) + static_cast<std::size_t>(number)) * padded_ + point / kGaussPoints;
  }

  std::size_t padded_ = 0;
  AlignedDoubles held_;
  std::vector<double> largest_;
  std::vector<LevelMix> mix_;
  std::vector<std::uint64_t> stamp_;
  std::vector<Slips> slips_;
};

}  // namespace overbend
