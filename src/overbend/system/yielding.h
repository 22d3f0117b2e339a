/// Elements whose steel may yield: their plastic moments in statics and in motion.
#pragma once

#include <vector>

#include "mechanics/bending_memories.h"
#include "mechanics/line_kernel.h"
#include "mechanics/plastic_bending.h"
#include "mechanics/quadrature.h"
#include "model/model.h"
#include "numerics/block_tridiagonal.h"
#include "system/line_mesh.h"

namespace overbend {

/// Laws of the elements; points into the model.
struct YieldingElements {
  std::vector<const BendingLaw*> law;  ///< Null for linear steel.
  std::vector<LevelMix> mix;           ///< Between the levels of the law.
  bool any = false;
  std::vector<bool> linear_pipe = {};  ///< Pipe of linear steel, whose places bend what passes them all the same.

  bool bends_passing(std::size_t element) const {
    return law[element] != nullptr || (!linear_pipe.empty() && linear_pipe[element]);
  }
};
YieldingElements yielding_elements(const Model& model, const LineMesh& mesh);

/// Chooses the levels by the height of each element's middle.
void choose_levels(YieldingElements& elements, const double* q);

/// Of a line that has not been bent before.
std::vector<BendingMemory> fresh_memories(const LineMesh& mesh, const double* q);

/// Where forces, and tangents unless null, are added.
struct YieldingTarget {
  std::vector<double>* residual = nullptr;
  BlockTridiagonal* tangent = nullptr;
  std::vector<double>* cuts = nullptr;  ///< As LineTarget::cuts.
};

/// A force that a roller exerts on an element, and what else the moment there depends on.
struct RollerPush {
  int element = 0;
  double xi = 0.0;
  Vec3 force = Vec3::Zero();  ///< W [N].
  Vec3 load = Vec3::Zero();   ///< Distributed on the element, with that of its tension times its curvature, W [N/m].
  double EI = 0.0;            ///< Bending stiffness of the element [N m2].
};

/// How steel yields in statics.
struct StaticYield {
  LayHistory history = LayHistory::laying;
  double share = 1.0;  ///< Of the plastic moments that acts, for continuation.
  /// What every Gauss point was before, in place of a history; null for none.
  const BendingMemory* before = nullptr;
  std::vector<RollerPush> pushes = {};  ///< By falling arc length, for LayHistory::laying.
};

/// Pipe of one law on its way from the tensioner down the line.
struct PassingPipe {
  const BendingLaw* law = nullptr;
  std::size_t last = 0;  ///< The element furthest from the tensioner that is of it.
  bool begun = false;
  BendingMemory memory = {};
};

/// What the Gauss points of a line in statics came to, kGaussPoints per element. In use only where steel yields.
struct StaticYielding {
  std::vector<Vec3> plastic_moment;   ///< World axes [N m].
  std::vector<BendingMemory> memory;  ///< Empty unless asked for.
  std::vector<PassingPipe> passing;   ///< One for each law.
};

/// Adds the plastic moments of a line at rest. With LayHistory::laying every section is what came to its place from
/// the tensioner without twist, through all curvatures in between, whatever pipe lies there now: the shape stands still
/// while the pipe moves through it. Cables and structures in between bend nothing. The tangent takes what happened
/// upstream as given. Under a roller a cubic element knows no peak of the curvature, and its Gauss points lie above or
/// below the true one by some per cent, as they happen to lie: there the pipe passes the curvature that its law has for
/// the moment that balances the element (StaticYield::pushes).
void add_static_yielding(const YieldingElements& elements, const LineMesh& mesh, const StaticYield& how,
                         const LineShape& q, bool keep_memory, StaticYielding& points, const YieldingTarget& target);

/// A line whose steel may have been bent.
struct BentLine {
  const LineMesh& mesh;
  const std::vector<double>& q;
  const std::vector<BendingMemory>& memory;
  const std::vector<RollerPush>& pushes;
};

/// What the Gauss points of `mesh` were when the line has moved along itself by `shift`, away from its top [m], from
/// how it lay before: each through all curvatures between its place and the one it came to, as the line lay. What had
/// not left the top yet begins there unbent. `elements`: of `mesh`.
std::vector<BendingMemory> moved_along(const BentLine& before, double shift, const YieldingElements& elements,
                                       const LineMesh& mesh);

/// How the steel of a line in motion yields over a step. Sections that nothing slides in are the element kernel's
/// (HeldSections), which also tells which those are not.
class MovingYielding {
 public:
  MovingYielding(const YieldingElements& elements, const LineMesh& mesh);

  /// A step that starts from `before`. `after` becomes the same, at the levels of the elements; where linear steel has
  /// come to lie, by rearrangement, it remembers nothing of what lay there.
  void begin(const BendingMemories& before, BendingMemories& after);
  /// For the kernel, which is to be called next.
  HeldSections held(const BendingMemories& before, BendingMemories& after);
  /// Adds the plastic moments of sections that slide, and leaves their memories in `after`. Returns the heat made since
  /// `before` [J].
  double add_sliding(const double* q, const BendingMemories& before, BendingMemories& after,
                     const YieldingTarget& target);
  /// Energy stored beyond that of elastic bending, as it was then [J].
  double stored() const;
  /// Sections that slid on the way to the end of the step, and hold there, remember nothing of it.
  void finish(const BendingMemories& before, BendingMemories& after);

 private:
  double left(std::size_t point) const { return left_[point % kGaussPoints * padded_ + point / kGaussPoints]; }
  void forget_slid();
  const BendingMemories& start(const BendingMemories& before) const { return fitted_.empty() ? before : fitted_; }

  const YieldingElements* elements_;
  const LineMesh* mesh_;
  std::size_t padded_;
  AlignedDoubles left_;            ///< As HeldSections.
  AlignedDoubles stored_held_;     ///< Partial sums.
  BendingMemories fitted_;         ///< The start of the step, where it did not fit the elements; else empty.
  std::vector<std::size_t> slid_;  ///< Points that slid in this step, if only on the way to its end;
  std::vector<bool> has_slid_;     ///< and whether a point is one of them.
  double stored_sliding_ = 0.0;
};

}  // namespace overbend
