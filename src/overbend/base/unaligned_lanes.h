/// Registers of doubles that are loaded from and stored to unaligned addresses. For kernels only, see simd.h: all code
/// is in the unnamed namespace of one instruction set.
#pragma once

#include "base/simd.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

using UnalignedLanes = double __attribute__((vector_size(8 * kWidth), may_alias, aligned(8)));

inline const UnalignedLanes& unaligned(const double* from) {
  return *reinterpret_cast<const UnalignedLanes*>(from);
}
inline UnalignedLanes& unaligned(double* address) {
  return *reinterpret_cast<UnalignedLanes*>(address);
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
