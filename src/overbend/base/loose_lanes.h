/// Registers of doubles that are loaded from and stored to any place. For kernels alone, see simd.h: everything stands
/// in the unnamed namespace of one instruction set.
#pragma once

#include "base/simd.h"

namespace overbend::OVERBEND_ISA_NAMESPACE {
namespace {

using LooseLanes = double __attribute__((vector_size(8 * kWidth), may_alias, aligned(8)));

inline const LooseLanes& loose(const double* from) {
  return *reinterpret_cast<const LooseLanes*>(from);
}
inline LooseLanes& loose(double* at) {
  return *reinterpret_cast<LooseLanes*>(at);
}

}  // namespace
}  // namespace overbend::OVERBEND_ISA_NAMESPACE
