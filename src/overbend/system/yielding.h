/// Elements whose steel may yield: their plastic moments in statics and in motion.
#pragma once

#include <vector>

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

/// How steel yields in statics.
struct StaticYield {
  LayHistory history = LayHistory::laying;
  double share = 1.0;  ///< Of the plastic moments that acts, for continuation.
  /// What every Gauss point was before, in place of a history; null for none.
  const BendingMemory* before = nullptr;
};

/// What the Gauss points of a line in statics came to, kGaussPoints per element. In use only where steel yields.
struct StaticYielding {
  std::vector<Vec3> plastic_moment;   ///< World axes [N m].
  std::vector<BendingMemory> memory;  ///< Empty unless asked for.
};

/// Adds the plastic moments of a line at rest. With LayHistory::laying every section is what came to its place from
/// the tensioner without twist, through all curvatures in between: the shape stands still while the pipe moves through
/// it. The tangent takes what happened upstream as given.
void add_static_yielding(const YieldingElements& elements, const LineMesh& mesh, const StaticYield& how,
                         const LineShape& q, bool keep_memory, StaticYielding& points, const YieldingTarget& target);

/// A line whose steel may have been bent.
struct BentLine {
  const LineMesh& mesh;
  const std::vector<double>& q;
  const std::vector<BendingMemory>& memory;
};

/// What the Gauss points of `mesh` were when the line has moved along itself by `shift`, away from its top [m], from
/// how it lay before: each through all curvatures between its place and the one it came to, as the line lay. What had
/// not left the top yet begins there unbent. `elements`: of `mesh`.
std::vector<BendingMemory> moved_along(const BentLine& before, double shift, const YieldingElements& elements,
                                       const LineMesh& mesh);

/// Adds those of a line in motion: `after` becomes what `before` was, bent on to `q`. Returns the heat made [J].
double add_moving_yielding(const YieldingElements& elements, const LineMesh& mesh, const double* q,
                           const std::vector<BendingMemory>& before, std::vector<BendingMemory>& after,
                           std::vector<Vec3>& plastic_moment, const YieldingTarget& target);

/// Energy stored beyond that of elastic bending [J].
double stored_by_yielding(const YieldingElements& elements, const LineMesh& mesh, const double* q,
                          const std::vector<BendingMemory>& memory);

/// Adds the plastic moments found to the internal force of one element.
void add_element_yielding(const LineMesh& mesh, int element, const LineShape& q, const Vec3* plastic_moment,
                          ElementVector& force);

}  // namespace overbend
