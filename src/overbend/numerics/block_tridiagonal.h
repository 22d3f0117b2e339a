/// Block-tridiagonal system with 6x6 blocks, one block row per node, and two right-hand sides.
///
///     [ D0 U0       ] [x0 y0]   [b0 c0]
///     [ L1 D1 U1    ] [x1 y1] = [b1 c1]
///     [    ..  ..   ] [.. ..]   [.. ..]
///
/// Friction and drag make the tangent unsymmetric, so no symmetry is assumed. The second right-hand side carries the
/// border of one extra unknown. A row of D is stored with its two right-hand sides as one vector of eight, so that
/// every row operation is one multiply-add. The elimination runs from both ends to the middle node, so that two
/// independent nodes are always in progress.
#pragma once

#include <cstddef>

#include "base/aligned.h"
#include "base/simd.h"
#include "numerics/block_tridiagonal_kernel.h"

namespace overbend {

class BlockTridiagonal {
 public:
  explicit BlockTridiagonal(int nodes = 0) { resize(nodes); }

  void resize(int nodes);
  void set_zero();
  int nodes() const { return nodes_; }
  /// Node where the eliminations from both ends meet.
  int middle() const { return nodes_ / 2; }

  /// Row-major 6 x 8: columns 0-5 the block, column 6 the first right-hand side, column 7 the second.
  double* diag(int node) { return diag_.data() + static_cast<std::size_t>(node) * kBlockSize; }
  const double* diag(int node) const { return diag_.data() + static_cast<std::size_t>(node) * kBlockSize; }
  /// Row-major 6 x 8, columns 0-5 couple `node` (rows) to `node + 1`; columns 6-7 stay zero.
  double* upper(int node) { return upper_.data() + static_cast<std::size_t>(node) * kBlockSize; }
  const double* upper(int node) const { return upper_.data() + static_cast<std::size_t>(node) * kBlockSize; }
  /// Row-major 6 x 8, columns 0-5 couple `node + 1` (rows) to `node`; columns 6-7 stay zero.
  double* lower(int node) { return lower_.data() + static_cast<std::size_t>(node) * kBlockSize; }
  const double* lower(int node) const { return lower_.data() + static_cast<std::size_t>(node) * kBlockSize; }

  /// Copies the blocks of `source`, which has as many nodes, from node `first` on: their rows, and the columns that
  /// couple them to each other.
  void copy_from(const BlockTridiagonal& source, int first);

  double rhs(int node, int dof, int side) const { return diag(node)[dof * kRowWidth + kNodeDofs + side]; }
  double& rhs(int node, int dof, int side) { return diag(node)[dof * kRowWidth + kNodeDofs + side]; }

 private:
  int nodes_ = 0;
  AlignedDoubles diag_, upper_, lower_;
};

/// Adds a 12x12 matrix of the unknowns of `node` and `node + 1`.
template <class Matrix>
void add_element(BlockTridiagonal& system, int node, const Matrix& k) {
  for (int row = 0; row < kNodeDofs; ++row) {
    for (int c = 0; c < kNodeDofs; ++c) {
      system.diag(node)[row * kRowWidth + c] += k(row, c);
      system.upper(node)[row * kRowWidth + c] += k(row, kNodeDofs + c);
      system.lower(node)[row * kRowWidth + c] += k(kNodeDofs + row, c);
      system.diag(node + 1)[row * kRowWidth + c] += k(kNodeDofs + row, kNodeDofs + c);
    }
  }
}

/// Solves in place by block elimination from both ends, with row pivoting inside each block; the solutions are in the
/// columns of the right-hand sides. The blocks are overwritten by the factors for `resolve`.
BlockSolveReport solve(BlockTridiagonal& system);

/// Solves a system already factored by `solve` for another right-hand side: `x`, six per node, holds it and receives
/// the solution. About a fifth of the work of `solve`.
void resolve(BlockTridiagonal& solved, double* x);

/// Refactors from node `first` on, which must not be beyond the middle and whose blocks have been set again; the
/// factors of the nodes before it are kept. Right-hand sides are left to `resolve`.
BlockSolveReport refactor(BlockTridiagonal& solved, int first);

/// Returns pointers to the blocks for the kernels.
BlockView make_block_view(BlockTridiagonal& system);

/// Solves on a given instruction set, for comparisons.
BlockSolveReport solve_on(BlockTridiagonal& system, Isa isa);
void resolve_on(BlockTridiagonal& solved, double* x, Isa isa);
BlockSolveReport refactor_on(BlockTridiagonal& solved, int first, Isa isa);

}  // namespace overbend
