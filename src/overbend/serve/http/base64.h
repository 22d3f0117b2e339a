/// Base64 encoding for JSON.
#pragma once

#include <span>
#include <string>

namespace overbend {

/// Returns the numbers as little-endian float32 in base64 (RFC 4648, padded).
std::string base64_floats(std::span<const float> numbers);

}  // namespace overbend
