/// Bytes as text for JSON.
#pragma once

#include <span>
#include <string>

namespace overbend {

/// Base64 (RFC 4648, padded) of the numbers as little-endian float32.
std::string base64_floats(std::span<const float> numbers);

}  // namespace overbend
