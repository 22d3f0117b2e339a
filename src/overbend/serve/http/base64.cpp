#include "serve/http/base64.h"

#include <cstdint>
#include <vector>

#include "base/bit_cast.h"

namespace overbend {
namespace {

constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

std::vector<std::uint8_t> little_endian(std::span<const float> numbers) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * numbers.size() + 2);
  for (const float number : numbers) {
    const auto bits = overbend::bit_cast<std::uint32_t>(number);
    for (unsigned shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(bits >> shift));
  }
  return bytes;
}

}  // namespace

std::string base64_floats(std::span<const float> numbers) {
  std::vector<std::uint8_t> bytes = little_endian(numbers);
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  bytes.resize(bytes.size() + padding);
  std::string text;
  text.reserve(bytes.size() / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = bytes[i] * 65536U + bytes[i + 1] * 256U + bytes[i + 2];
    for (const unsigned shift : {18U, 12U, 6U, 0U}) text += kLetters[(group >> shift) & 63U];
  }
  for (std::size_t i = 0; i < padding; ++i) text[text.size() - 1 - i] = '=';
  return text;
}

std::optional<std::string> bytes_from_base64(std::string_view text) {
  if (text.size() % 4 != 0) return std::nullopt;
  std::size_t padding = 0;
  while (padding < 2 && padding < text.size() && text[text.size() - 1 - padding] == '=') ++padding;
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    std::uint32_t group = 0;
    for (std::size_t k = i; k < i + 4; ++k) {
      const std::size_t value = k < text.size() - padding ? kLetters.find(text[k]) : 0;
      if (value == std::string_view::npos) return std::nullopt;
      group = group << 6U | static_cast<std::uint32_t>(value);
    }
    for (const unsigned shift : {16U, 8U, 0U}) bytes += static_cast<char>(group >> shift & 255U);
  }
  bytes.resize(bytes.size() - padding);
  return bytes;
}

}  // namespace overbend
