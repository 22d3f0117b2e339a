/// Base64 for JSON.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace overbend {

/// Returns the numbers as little-endian float32 in base64 (RFC 4648, padded).
std::string base64_floats(std::span<const float> numbers);

/// Returns the bytes of a base64 text (RFC 4648, padded); nothing if it is none.
std::optional<std::string> bytes_from_base64(std::string_view text);

}  // namespace overbend
