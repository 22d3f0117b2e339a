/// Conversion of arbitrary bytes to valid UTF-8.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace overbend {

/// Returns the length of the UTF-8 character that begins at `i`; 0 if none does (overlong forms and surrogates are
/// invalid).
std::size_t utf8_length(std::string_view text, std::size_t i);

/// Returns the text with every byte outside a valid character written as "\xc6". Applied to messages where they are
/// collected (base/diagnostics.h) and at the program's output.
std::string valid_utf8(std::string_view text);

}  // namespace overbend
