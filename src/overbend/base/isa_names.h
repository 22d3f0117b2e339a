/// Names of the instruction sets, in OVERBEND_ISA and in the record of a run.
#pragma once

#include <array>

#include "base/enum_names.h"
#include "base/simd.h"

namespace overbend {

template <>
inline constexpr std::array kEnumNames<Isa> = {
    Word{Isa::baseline, "baseline"},
    Word{Isa::avx2, "avx2"},
    Word{Isa::avx512, "avx512"},
};

}  // namespace overbend
