/// Tension and moments at the nodes of a line from their unknowns and cuts. Compiled once per instruction set; raw
/// pointers only, see wave_kernel.h.
#pragma once

namespace overbend {

/// Six values per node.
struct NodeRows {
  const double* q;     ///< Position and tangent.
  const double* cuts;  ///< Force and moment, see LineAssembly::cuts().
};

/// One array per quantity; none overlaps another.
struct RecoveredNodes {
  double *x, *y, *z;   ///< Position [m].
  double* tangent[3];  ///< Unit.
  double* bend[3];     ///< Bending moment, towards the centre of curvature [N m].
  double* tension;     ///< Effective tension [N].
  double* moment;      ///< Magnitude of the bending moment [N m].
  double* vertical;    ///< Its component upwards across the pipe; 0 for an upright pipe [N m].
};

using RecoverKernel = void (*)(const NodeRows& rows, int count, const RecoveredNodes& out);

namespace isa_baseline {
void recover_nodes(const NodeRows& rows, int count, const RecoveredNodes& out);
}  // namespace isa_baseline
namespace isa_avx2 {
void recover_nodes(const NodeRows& rows, int count, const RecoveredNodes& out);
}  // namespace isa_avx2
namespace isa_avx512 {
void recover_nodes(const NodeRows& rows, int count, const RecoveredNodes& out);
}  // namespace isa_avx512

}  // namespace overbend
