/// Text that is UTF-8 whatever it was made from: files of the user may hold any bytes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace overbend {

/// Length of the UTF-8 character that begins at `i`; 0 where none does (overlong forms and surrogates are none).
std::size_t utf8_length(std::string_view text, std::size_t i);

/// The text with every byte that belongs to no character written as "\xc6". Messages go through this once, where they
/// are collected (base/diagnostics.h) or where they leave the program.
std::string valid_utf8(std::string_view text);

}  // namespace overbend
