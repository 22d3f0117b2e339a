/// The instruction sets that kernels can be compared on.
#pragma once

#include <vector>

#include "base/simd.h"

namespace overbend {

/// Instruction sets of this machine, narrowest first.
inline std::vector<Isa> available_isas() {
  std::vector<Isa> isas;
  for (const Isa isa : {Isa::baseline, Isa::avx2, Isa::avx512}) {
    if (isa <= best_isa()) {
      isas.push_back(isa);
    }
  }
  return isas;
}

}  // namespace overbend
