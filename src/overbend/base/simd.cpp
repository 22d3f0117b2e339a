#include "base/simd.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace overbend {
namespace {

Isa detect() {
#if defined(OVERBEND_X86_KERNELS)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
    return Isa::avx512;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return Isa::avx2;
  }
#endif
  return Isa::baseline;
}

Isa narrow(Isa found) {
  const char* wanted = std::getenv("OVERBEND_ISA");
  const std::string name = wanted == nullptr ? "" : wanted;
  if (name.empty() || name == "avx512") return found;
  if (name == "avx2") return found == Isa::avx512 ? Isa::avx2 : found;
  if (name == "baseline") return Isa::baseline;
  throw std::invalid_argument("the environment variable OVERBEND_ISA: found '" + name +
                              "', expected baseline, avx2 or avx512");
}

}  // namespace

Isa best_isa() {
  static const Isa isa = narrow(detect());
  return isa;
}

}  // namespace overbend
