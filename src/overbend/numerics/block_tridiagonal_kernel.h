/// The elimination, compiled once per instruction set.
#pragma once

namespace overbend {

class BlockTridiagonal;
struct BlockSolveReport;

namespace isa_baseline {
BlockSolveReport solve_blocks(BlockTridiagonal& system);
}
namespace isa_avx2 {
BlockSolveReport solve_blocks(BlockTridiagonal& system);
}
namespace isa_avx512 {
BlockSolveReport solve_blocks(BlockTridiagonal& system);
}

}  // namespace overbend
