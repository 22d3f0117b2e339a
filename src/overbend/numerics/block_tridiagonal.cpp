#include "numerics/block_tridiagonal.h"

#include <algorithm>

namespace overbend {

void BlockTridiagonal::resize(int nodes) {
  nodes_ = nodes;
  const std::size_t n = static_cast<std::size_t>(nodes);
  diag_.assign(n * kDiagSize, 0.0);
  upper_.assign(n * kDiagSize, 0.0);
  lower_.assign(n * kLowerSize, 0.0);
}

void BlockTridiagonal::set_zero() {
  std::fill(diag_.begin(), diag_.end(), 0.0);
  std::fill(upper_.begin(), upper_.end(), 0.0);
  std::fill(lower_.begin(), lower_.end(), 0.0);
}

BlockSolveReport solve_on(BlockTridiagonal& system, Isa isa) {
  const BlockView view{system.nodes(), system.diag(0), system.upper(0), system.lower(0)};
#if defined(OVERBEND_X86_KERNELS)
  if (isa == Isa::avx512) {
    return isa_avx512::solve_blocks(view);
  }
  if (isa == Isa::avx2) {
    return isa_avx2::solve_blocks(view);
  }
#endif
  (void)isa;
  return isa_baseline::solve_blocks(view);
}

BlockSolveReport solve(BlockTridiagonal& system) {
  return solve_on(system, best_isa());
}

}  // namespace overbend
