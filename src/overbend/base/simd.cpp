#include "base/simd.h"

#include <cstdlib>
#include <string_view>

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
  if (wanted == nullptr) {
    return found;
  }
  const std::string_view name(wanted);
  if (name == "baseline") {
    return Isa::baseline;
  }
  return name == "avx2" && found == Isa::avx512 ? Isa::avx2 : found;
}

}  // namespace

Isa best_isa() {
  static const Isa isa = narrow(detect());
  return isa;
}

}  // namespace overbend
