/// What yielding takes from the elastic bending moment of the rod, point by point.
///
/// The element kernel bends every element elastically, EI k with k = dt/ds the curvature vector. Where a section yields
/// its moment is EI k - M_p; this file finds M_p from the law's springs (model/pipe/bending_law.h) and the memory of
/// the section, and takes it off again. Elements that never yielded cost nothing.
///
/// The memory lives in axes that the section carries along without spin: the smallest turn that takes the old tangent
/// to the new one (parallel transport, as in Bishop 1975). A pipe bent in one plane and then in another keeps what the
/// first did to it.
#pragma once

#include <cstdint>

#include "mechanics/rod_element.h"
#include "model/pipe/bending_law.h"

namespace overbend {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;

using Slips = std::array<double, kSliders * kDirections>;  ///< By slider, then direction [1/m].

/// Memory of one section of pipe.
struct BendingMemory {
  Vec3 tangent = Vec3::UnitX();  ///< Direction of the pipe when the axis below was taken.
  Vec3 axis = Vec3::UnitY();     ///< First axis across the pipe; the second is tangent x axis.
  Vec2 center = Vec2::Zero();    ///< Nothing slides while the curvature stays this close to here:
  double slack = -1.0;           ///< [1/m]; negative: not known yet.
  double largest = 0.0;          ///< Curvature at which it has yielded, the largest so far [1/m].
  Vec2 held = Vec2::Zero();      ///< Plastic moment of the slips, at `held_mix` [N m].
  double stored = 0.0;           ///< Half the sum of stiffness times slip squared, at `held_mix` [J/m].
  LevelMix held_mix = {-1, 0.0};
  std::uint64_t stamp = 0;  ///< Made of the whole history of the slips; 0: never slid.
  alignas(64) Slips slip{};
};

/// Answer of a section to a curvature.
struct BendingAnswer {
  Vec2 plastic_moment = Vec2::Zero();   ///< EI k - M [N m].
  Mat2 plastic_tangent = Mat2::Zero();  ///< Its derivative.
  double loss = 0.0;                    ///< Work turned to heat since `memory`, per length [J/m].
  bool sliding = false;                 ///< Any spring slides.
};

/// Bends a section whose memory has been brought along; `memory` becomes what it is afterwards.
BendingAnswer bend(const BendingLaw& law, const LevelMix& mix, const Vec2& curvature, BendingMemory& memory);

/// Energy in the springs minus that of EI k^2/2, of a section bent before at its level [J/m].
inline double stored_beyond_elastic(const Vec2& curvature, const BendingMemory& memory) {
  return memory.stored - curvature.dot(memory.held);
}

/// Curvature at which the section carries a moment; memory as it will be there.
Vec2 curvature_for(const BendingLaw& law, const LevelMix& mix, double EI, const Vec2& moment, BendingMemory& memory);

/// Curvature that would be left without moment: M_p/EI, if nothing yields on the way [1/m].
Vec2 residual_curvature(const BendingLaw& law, const LevelMix& mix, double EI, const BendingMemory& memory);

/// Finds anew what the slips hold and store where they were last known for other stiffnesses.
void bring_to_level(const BendingLaw& law, const LevelMix& mix, BendingMemory& memory);

/// Turns the axes of a memory with the pipe to a new unit tangent.
void bring_along(BendingMemory& memory, const Vec3& tangent);

/// Axes for a section that has not been bent.
BendingMemory fresh_memory(const Vec3& tangent);

/// Curvature vector dt/ds of a centreline point [1/m].
Vec3 curvature_vector(const CentrelinePoint& at);

/// Components in the axes of a memory, and back.
inline Vec2 in_axes(const BendingMemory& memory, const Vec3& v) {
  return {v.dot(memory.axis), v.dot(memory.tangent.cross(memory.axis))};
}
inline Vec3 from_axes(const BendingMemory& memory, const Vec2& v) {
  return v.x() * memory.axis + v.y() * memory.tangent.cross(memory.axis);
}

/// Adds what a plastic moment (world axes) at a Gauss point takes off the element's internal force, and with
/// `stiffness` off its tangent, where `tangent` is dM_p/dk across the pipe, world axes; null for none. `weight` is the
/// Gauss weight times the element's length. Only derivatives of shape and point are used.
void add_plastic_point(const HermiteValues& shape, const CentrelinePoint& at, double weight, const Vec3& plastic_moment,
                       const Mat3* tangent, ElementVector& force, ElementMatrix* stiffness);

}  // namespace overbend
