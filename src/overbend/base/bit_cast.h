/// The bits of a value as another type.
#pragma once

#include <type_traits>

#include "base/bit_cast.h"

namespace overbend {

/// As bit_cast, which libc++ before 14 lacks.
template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
  return __builtin_bit_cast(To, from);
}

}  // namespace overbend
