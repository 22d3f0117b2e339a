#include "base/utf8.h"

#include <algorithm>

namespace overbend {
namespace {

/// Length implied by the first byte, and the bounds of the second one.
struct Start {
  std::size_t length = 0;
  unsigned low = 0x80, high = 0xbf;
};

Start start_with(unsigned byte) {
  if (byte < 0x80) return {1};
  if (byte >= 0xc2 && byte <= 0xdf) return {2};
  if (byte >= 0xe0 && byte <= 0xef) return {3, byte == 0xe0 ? 0xa0U : 0x80U, byte == 0xed ? 0x9fU : 0xbfU};
  if (byte >= 0xf0 && byte <= 0xf4) return {4, byte == 0xf0 ? 0x90U : 0x80U, byte == 0xf4 ? 0x8fU : 0xbfU};
  return {};
}

bool is_ascii(char letter) {
  return static_cast<unsigned char>(letter) < 0x80;
}

}  // namespace

std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned>(static_cast<unsigned char>(text[k])); };
  const Start start = start_with(byte(i));
  if (start.length == 0 || i + start.length > text.size()) return 0;
  if (start.length > 1 && (byte(i + 1) < start.low || byte(i + 1) > start.high)) return 0;
  for (std::size_t k = 2; k < start.length; ++k) {
    if ((byte(i + k) & 0xc0U) != 0x80U) return 0;
  }
  return start.length;
}

std::string valid_utf8(std::string_view text) {
  if (std::all_of(text.begin(), text.end(), is_ascii)) return std::string(text);
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string valid;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length > 0) {
      valid.append(text.substr(i, length));
      i += length;
      continue;
    }
    const auto byte = static_cast<unsigned char>(text[i++]);
    valid.append("\\x").append(1, kDigits[byte >> 4U]).append(1, kDigits[byte & 0xfU]);
  }
  return valid;
}

}  // namespace overbend
