/// Plastic reduction of the elastic bending moment of the rod, point by point.
///
/// The element kernel bends every element elastically, EI k with k = dt/ds the curvature vector. The moment of a
/// yielding section is EI k - M_p; this file computes M_p from the springs of the law (model/pipe/bending_law.h) and
/// the memory of the section, and subtracts it. Elements that never yielded cost nothing.
///
/// The memory is in axes that move with the section without spin: the smallest rotation from the old tangent to the new
/// one (parallel transport, as in Bishop 1975). Memory of bending in one plane is kept when the pipe is bent in
/// another.
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
  Vec3 tangent = Vec3::UnitX();  ///< Direction of the pipe for which the axis below is given.
  Vec3 axis = Vec3::UnitY();     ///< First axis across the pipe; the second is tangent x axis.
  Vec2 center = Vec2::Zero();    ///< No spring slips while the curvature stays this close to here:
  double slack = -1.0;           ///< [1/m]; negative: unknown.
  double max_curvature = 0.0;    ///< Maximum curvature at which it has yielded so far [1/m].
  Vec2 held = Vec2::Zero();      ///< Plastic moment of the slips, at `held_mix` [N m].
  double stored = 0.0;           ///< Half the sum of stiffness times slip squared, at `held_mix` [J/m].
  LevelMix held_mix = {-1, 0.0};
  std::uint64_t stamp = 0;  ///< Hash of the whole slip history; 0: never slipped.
  alignas(64) Slips slip{};
};

/// Response of a section to a curvature.
struct BendingResponse {
  Vec2 plastic_moment = Vec2::Zero();   ///< EI k - M [N m].
  Mat2 plastic_tangent = Mat2::Zero();  ///< Its derivative.
  double loss = 0.0;                    ///< Dissipated work since `memory`, per length [J/m].
  bool sliding = false;                 ///< True if any spring slips.
};

/// Bends a section whose memory has been transported to the current tangent, and updates `memory`.
BendingResponse bend(const BendingLaw& law, const LevelMix& mix, const Vec2& curvature, BendingMemory& memory);

/// Returns the energy in the springs minus that of EI k^2/2, for a section bent before at its level [J/m].
inline double stored_beyond_elastic(const Vec2& curvature, const BendingMemory& memory) {
  return memory.stored - curvature.dot(memory.held);
}

/// Returns the curvature at which the section carries a moment, and updates the memory to it.
Vec2 find_curvature(const BendingLaw& law, const LevelMix& mix, double EI, const Vec2& moment, BendingMemory& memory);

/// Returns the residual curvature at zero moment: M_p/EI, if nothing yields during unloading [1/m].
Vec2 residual_curvature(const BendingLaw& law, const LevelMix& mix, double EI, const BendingMemory& memory);

/// Recomputes held moment and stored energy of the slips if they were last computed for other stiffnesses.
void update_held_moment(const BendingLaw& law, const LevelMix& mix, BendingMemory& memory);

/// Transports the axes of a memory with the pipe to a new unit tangent.
void transport_axes(BendingMemory& memory, const Vec3& tangent);

/// Returns the memory of a section that has not been bent.
BendingMemory make_bending_memory(const Vec3& tangent);

/// Returns the curvature vector dt/ds of a centreline point [1/m].
Vec3 curvature_vector(const CentrelinePoint& centreline);

/// Transform to the axes of a memory, and back.
inline Vec2 in_axes(const BendingMemory& memory, const Vec3& v) {
  return {v.dot(memory.axis), v.dot(memory.tangent.cross(memory.axis))};
}
inline Vec3 from_axes(const BendingMemory& memory, const Vec2& v) {
  return v.x() * memory.axis + v.y() * memory.tangent.cross(memory.axis);
}

/// Subtracts the contribution of a plastic moment (world axes) at a Gauss point from the element's internal force, and
/// with `stiffness` from its tangent, where `tangent` is dM_p/dk across the pipe, world axes; null for none. `weight`
/// is the Gauss weight times the element's length. Only derivatives of shape and point are used.
void add_plastic_point(const HermiteValues& shape, const CentrelinePoint& centreline, double weight,
                       const Vec3& plastic_moment, const Mat3* tangent, ElementVector& force, ElementMatrix* stiffness);

}  // namespace overbend
