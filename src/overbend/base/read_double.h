/// The decimal number at the beginning of a text.
#pragma once

#include <charconv>

namespace overbend {

/// As std::from_chars for a double, which libc++ before 20 lacks: reads the longest number at `first`, in the C locale,
/// without leading blanks or plus sign.
std::from_chars_result read_double(const char* first, const char* last, double& value);

}  // namespace overbend
