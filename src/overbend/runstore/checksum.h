/// Checksums that detect damaged data; no protection against deliberate changes.
#pragma once

#include <cstdint>

namespace overbend {

inline constexpr std::uint64_t kChecksumStart = 0x9e3779b97f4a7c15ULL;

/// The sum so far with the next 64 bits. One-to-one in both, so that no single change goes unseen; the shift lets high
/// bits meet low ones. After FNV-1a, with a word in the place of a byte.
constexpr std::uint64_t add_to_checksum(std::uint64_t sum, std::uint64_t word) {
  sum = (sum ^ word) * 0x100000001b3ULL;
  return sum ^ (sum >> 29U);
}

}  // namespace overbend
