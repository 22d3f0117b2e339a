/// Valid UTF-8 from files that may hold any bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace overbend {

/// Length of the UTF-8 character that begins at `i`; 0 where none does (overlong forms and surrogates are none).
std::size_t utf8_length(std::string_view text, std::size_t i);

/// The text with every byte outside a valid character written as "\xc6". Applied to messages where they are collected
/// (base/diagnostics.h) and where they leave the program.
std::string valid_utf8(std::string_view text);

}  // namespace overbend
