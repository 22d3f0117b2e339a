/// Portable vectors of doubles, and selection of the instruction set.
///
/// Kernels (files named *_kernel.cpp) are compiled once per instruction set into a separate namespace, with compiler
/// vectors as wide as the set's registers (8, 4 or 2 doubles); data is laid out in batches of eight, a multiple of
/// every width. `best_isa` chooses at run time, so that one program runs on any x86-64 machine and uses the widest
/// registers available.
#pragma once

namespace overbend {

inline constexpr int kLanes = 8;  ///< Elements in a batch of data.

enum class Isa { baseline, avx2, avx512 };

/// Returns the widest instruction set of this processor and this build. The environment variable OVERBEND_ISA
/// (baseline, avx2, avx512) restricts it, to compare results between sets; another value throws std::invalid_argument.
Isa best_isa();

}  // namespace overbend

#if defined(OVERBEND_ISA_NAMESPACE)
namespace overbend::OVERBEND_ISA_NAMESPACE {
inline constexpr int kWidth = OVERBEND_ISA_WIDTH;  ///< Doubles in a register.
using Lanes = double __attribute__((vector_size(8 * OVERBEND_ISA_WIDTH), may_alias));
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
#endif
