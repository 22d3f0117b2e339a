/// What the instruction sets are called, in OVERBEND_ISA and in the record of a run.
#pragma once

#include <array>

#include "base/simd.h"
#include "base/words.h"

namespace overbend {

template <>
inline constexpr std::array kWords<Isa> = {
    Word{Isa::baseline, "baseline"},
    Word{Isa::avx2, "avx2"},
    Word{Isa::avx512, "avx512"},
};

}  // namespace overbend
