#include "base/simd.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "base/isa_names.h"
#include "base/text.h"

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
  if (name.empty()) return found;
  if (const auto isa = from_enum_name<Isa>(name)) return std::min(*isa, found);
  throw std::invalid_argument("the environment variable OVERBEND_ISA: found '" + name + "', expected " +
                              join_items(enum_names<Isa>(), "or"));
}

}  // namespace

Isa best_isa() {
  static const Isa isa = narrow(detect());
  return isa;
}

}  // namespace overbend
