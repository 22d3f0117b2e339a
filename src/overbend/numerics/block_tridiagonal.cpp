#include "numerics/block_tridiagonal.h"

#include <algorithm>

#include "base/require.h"

namespace overbend {

void BlockTridiagonal::resize(int nodes) {
  nodes_ = nodes;
  const std::size_t n = static_cast<std::size_t>(nodes);
  diag_.assign(n * kBlockSize, 0.0);
  upper_.assign(n * kBlockSize, 0.0);
  lower_.assign(n * kBlockSize, 0.0);
}

void BlockTridiagonal::set_zero() {
  std::fill(diag_.begin(), diag_.end(), 0.0);
  std::fill(upper_.begin(), upper_.end(), 0.0);
  std::fill(lower_.begin(), lower_.end(), 0.0);
}

void BlockTridiagonal::copy_from(const BlockTridiagonal& source, int first) {
  const auto from = static_cast<std::ptrdiff_t>(first) * kBlockSize;
  std::copy(source.diag_.begin() + from, source.diag_.end(), diag_.begin() + from);
  std::copy(source.upper_.begin() + from, source.upper_.end(), upper_.begin() + from);
  std::copy(source.lower_.begin() + from, source.lower_.end(), lower_.begin() + from);
}

BlockView make_block_view(BlockTridiagonal& system) {
  return {system.nodes(), system.middle(), system.diag(0), system.upper(0), system.lower(0)};
}

namespace {

/// Kernels of one instruction set.
struct BlockKernels {
  BlockSolveReport (*solve)(const BlockView& system);
  void (*resolve)(const BlockView& system, double* x);
  BlockSolveReport (*factor)(const BlockView& system, int first);
};

BlockKernels kernels_for(Isa isa) {
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return {isa_avx512::solve_blocks, isa_avx512::resolve_blocks, isa_avx512::factor_blocks};
  }
  if (isa == Isa::avx2) {
    return {isa_avx2::solve_blocks, isa_avx2::resolve_blocks, isa_avx2::factor_blocks};
  }
#endif
  (void)isa;
  return {isa_baseline::solve_blocks, isa_baseline::resolve_blocks, isa_baseline::factor_blocks};
}

}  // namespace

BlockSolveReport solve_on(BlockTridiagonal& system, Isa isa) {
  return kernels_for(isa).solve(make_block_view(system));
}

void resolve_on(BlockTridiagonal& solved, double* x, Isa isa) {
  kernels_for(isa).resolve(make_block_view(solved), x);
}

BlockSolveReport refactor_on(BlockTridiagonal& solved, int first, Isa isa) {
  require(first <= solved.middle(), "refactoring starts at or before the middle node");
  return kernels_for(isa).factor(make_block_view(solved), first);
}

BlockSolveReport solve(BlockTridiagonal& system) {
  return solve_on(system, best_isa());
}

void resolve(BlockTridiagonal& solved, double* x) {
  resolve_on(solved, x, best_isa());
}

BlockSolveReport refactor(BlockTridiagonal& solved, int first) {
  return refactor_on(solved, first, best_isa());
}

}  // namespace overbend
