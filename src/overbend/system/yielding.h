/// Elements whose steel may yield: plastic moments in statics and dynamics.
#pragma once

#include <vector>

#include "mechanics/bending_histories.h"
#include "mechanics/line_kernel.h"
#include "mechanics/plastic_bending.h"
#include "mechanics/quadrature.h"
#include "model/model.h"
#include "numerics/block_tridiagonal.h"
#include "system/line_mesh.h"

namespace overbend {

/// Bending laws of the elements; points into the model.
struct YieldingElements {
  std::vector<const BendingLaw*> law;  ///< Null for linear steel.
  std::vector<LevelMix> mix;           ///< Between the levels of the law.
  bool any = false;
  /// Pipe of linear steel whose curvature nevertheless bends the pipe that passes it.
  std::vector<bool> linear_pipe = {};

  bool bends_passing(std::size_t element) const {
    return law[element] != nullptr || (!linear_pipe.empty() && linear_pipe[element]);
  }
};
/// Returns the bending laws of a model's line on a mesh.
YieldingElements yielding_elements(const Model& model, const LineMesh& mesh);

/// Chooses the levels by the height of each element's middle.
void choose_levels(YieldingElements& elements, const double* q);

/// Returns the memories of a line without bending history.
std::vector<BendingMemory> fresh_memories(const LineMesh& mesh, const double* q);

/// Targets of forces and, unless null, tangents.
struct YieldingTarget {
  std::vector<double>* residual = nullptr;
  BlockTridiagonal* tangent = nullptr;
  std::vector<double>* cuts = nullptr;  ///< As LineTarget::cuts.
};

/// Roller force on an element, with the other loads that determine the moment there.
struct RollerPush {
  int element = 0;
  double xi = 0.0;
  Vec3 force = Vec3::Zero();  ///< W [N].
  Vec3 load = Vec3::Zero();   ///< Distributed on the element, including tension times curvature, W [N/m].
  double EI = 0.0;            ///< Bending stiffness of the element [N m2].
};

/// Settings of plasticity in statics.
struct StaticYield {
  LayHistory history = LayHistory::laying;
  double share = 1.0;  ///< Factor on the plastic moments, for continuation.
  /// Previous memory of every Gauss point, in place of a history; null for none.
  const BendingMemory* before = nullptr;
  std::vector<RollerPush> pushes = {};  ///< By descending arc length, for LayHistory::laying.
};

/// Pipe of one law on its way from the tensioner down the line.
struct PassingPipe {
  const BendingLaw* law = nullptr;
  std::size_t last = 0;  ///< Its element furthest from the tensioner.
  bool begun = false;
  BendingMemory memory = {};
};

/// Plastic state of the Gauss points of a line in statics, kGaussPoints per element. Only used if steel yields.
struct StaticYielding {
  std::vector<Vec3> plastic_moment;   ///< World axes [N m].
  std::vector<BendingMemory> memory;  ///< Empty unless requested.
  std::vector<PassingPipe> passing;   ///< One per law.
};

/// Adds the plastic moments of a line at rest. With LayHistory::laying every section has come to its position from the
/// tensioner without twist, through all curvatures in between, regardless of the pipe that lies there now: the shape is
/// constant while the pipe moves through it. Cables and structures in between do not bend it. The tangent takes the
/// bending upstream as given. A cubic element cannot represent the curvature peak under a roller, and its Gauss points
/// deviate from it by some per cent depending on their positions: there the pipe passes the curvature that its law has
/// for the moment that balances the element (StaticYield::pushes).
void add_static_yielding(const YieldingElements& elements, const LineMesh& mesh, const StaticYield& how,
                         const LineShape& q, bool keep_memory, StaticYielding& points, const YieldingTarget& target);

/// A line with bending history.
struct BentLine {
  const LineMesh& mesh;
  const std::vector<double>& q;
  const std::vector<BendingMemory>& memory;
  const std::vector<RollerPush>& pushes;
};

/// Returns the memories of the Gauss points of `mesh` after the line has moved along itself by `shift`, away from its
/// top [m], from its previous configuration: each point passes all curvatures between its old and new positions. Points
/// that had not left the top begin there unbent. `elements`: of `mesh`.
std::vector<BendingMemory> moved_along(const BentLine& before, double shift, const YieldingElements& elements,
                                       const LineMesh& mesh);

/// Plasticity of a moving line over a step. Sections that do not slide are computed by the element kernel
/// (HeldSections), which also detects sliding.
class MovingYielding {
 public:
  MovingYielding(const YieldingElements& elements, const LineMesh& mesh);

  /// Starts a step at `before`. `after` becomes the same, at the levels of the elements; memories that a mesh change
  /// has moved to linear steel are dropped.
  void begin(const BendingMemories& before, BendingMemories& after);
  /// Data for the kernel, which must be called next.
  HeldSections held(const BendingMemories& before, BendingMemories& after);
  /// Adds the plastic moments of sliding sections and stores their memories in `after`. Returns the heat dissipated
  /// since `before` [J].
  double add_sliding(const double* q, const BendingMemories& before, BendingMemories& after,
                     const YieldingTarget& target);
  /// Returns the energy stored in excess of elastic bending at that state [J].
  double stored() const;
  /// Drops the memory of sections that slid during the iteration but hold at the end of the step.
  void finish(const BendingMemories& before, BendingMemories& after);

 private:
  double left(std::size_t point) const { return left_[point % kGaussPoints * padded_ + point / kGaussPoints]; }
  void forget_slid();
  const BendingMemories& start(const BendingMemories& before) const { return fitted_.empty() ? before : fitted_; }

  const YieldingElements* elements_;
  const LineMesh* mesh_;
  std::size_t padded_;
  AlignedDoubles left_;            ///< As in HeldSections.
  AlignedDoubles stored_held_;     ///< Partial sums.
  BendingMemories fitted_;         ///< Start of the step if it did not match the elements; else empty.
  std::vector<std::size_t> slid_;  ///< Points that slid in this step, possibly only during the iteration,
  std::vector<bool> has_slid_;     ///< and whether a point is one of them.
  double stored_sliding_ = 0.0;
};

}  // namespace overbend
