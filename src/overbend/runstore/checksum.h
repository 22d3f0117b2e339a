/// Checksums that detect damaged data; no protection against deliberate changes.
#pragma once

#include <cstdint>

namespace overbend {

inline constexpr std::uint64_t kChecksumStart = 0x9e3779b97f4a7c15ULL;

/// Returns the checksum including the next 64 bits. One-to-one in both, so that every single change is detected; the
/// shift mixes high and low bits. After FNV-1a, with a 64-bit word in place of a byte.
constexpr std::uint64_t add_to_checksum(std::uint64_t sum, std::uint64_t word) {
  sum = (sum ^ word) * 0x100000001b3ULL;
  return sum ^ (sum >> 29U);
}

}  // namespace overbend
