/// Block elimination, compiled once per instruction set.
#pragma once

namespace overbend {

inline constexpr int kNodeDofs = 6;
inline constexpr int kRowWidth = 8;  ///< Six columns and two right-hand sides.
inline constexpr int kBlockSize = kNodeDofs * kRowWidth;

struct BlockSolveReport {
  int singular_node = -1;   ///< First node whose eliminated block has no pivot, -1 when solved.
  int negative_blocks = 0;  ///< Eliminated blocks with negative determinant: zero for a stable equilibrium.
  bool solved() const { return singular_node < 0; }
};

/// Pointers into a BlockTridiagonal. Raw pointers only, so that no inline function of another header is compiled for an
/// instruction set that the machine may lack.
struct BlockView {
  int nodes;
  int middle;  ///< Node where the eliminations from both ends meet.
  double *diag, *upper, *lower;
};

namespace isa_baseline {
BlockSolveReport solve_blocks(const BlockView& system);
BlockSolveReport factor_blocks(const BlockView& system, int first);
void resolve_blocks(const BlockView& system, double* x);
}  // namespace isa_baseline
namespace isa_avx2 {
BlockSolveReport solve_blocks(const BlockView& system);
BlockSolveReport factor_blocks(const BlockView& system, int first);
void resolve_blocks(const BlockView& system, double* x);
}  // namespace isa_avx2
namespace isa_avx512 {
BlockSolveReport solve_blocks(const BlockView& system);
BlockSolveReport factor_blocks(const BlockView& system, int first);
void resolve_blocks(const BlockView& system, double* x);
}  // namespace isa_avx512

}  // namespace overbend
