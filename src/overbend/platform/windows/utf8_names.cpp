// Names of files in UTF-8. The C library of this compiler takes names in the code page of the system, and its C++
// library converts narrow to wide ones byte by byte. The linker replaces their two functions by these (--wrap,
// src/CMakeLists.txt).
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <cwchar>

#include "platform/windows/system.h"

namespace {

constexpr std::size_t kInvalid = static_cast<std::size_t>(-1), kIncomplete = static_cast<std::size_t>(-2);
constexpr unsigned kPending = 0x10000;  ///< Marks a state with the upper bits of a low surrogate.

/// Length of the sequence that a byte begins; 0 if none does.
std::size_t sequence_length(unsigned char first) {
  return first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
}

}  // namespace

extern "C" {

std::size_t __wrap_mbrtowc(wchar_t* wide, const char* text, std::size_t size, std::mbstate_t* state);
std::FILE* __wrap_fopen(const char* name, const char* mode);
std::FILE* __wrap_fopen64(const char* name, const char* mode);

/// Converts the next character to UTF-16. Of a sequence of four bytes, three give the high surrogate, the last one the
/// low surrogate.
std::size_t __wrap_mbrtowc(wchar_t* wide, const char* text, std::size_t size, std::mbstate_t* state) {
  if (text == nullptr) return 0;
  if (size == 0) return kIncomplete;
  const auto octet = [text](std::size_t i) { return static_cast<unsigned>(static_cast<unsigned char>(text[i])); };
  const auto give = [wide](unsigned unit) {
    if (wide != nullptr) *wide = static_cast<wchar_t>(unit);
  };
  unsigned pending = 0;
  if (state != nullptr) std::memcpy(&pending, state, sizeof pending);
  if ((pending & kPending) != 0) {
    if ((octet(0) & 0xC0U) != 0x80U) return kInvalid;
    give(0xDC00U | (pending & 0x3C0U) | (octet(0) & 0x3FU));
    std::memset(state, 0, sizeof *state);
    return 1;
  }
  const std::size_t length = sequence_length(static_cast<unsigned char>(text[0]));
  if (length == 0) return kInvalid;
  if (size < length) return kIncomplete;
  for (std::size_t i = 1; i < length; ++i) {
    if ((octet(i) & 0xC0U) != 0x80U) return kInvalid;
  }
  if (length == 1) {
    give(octet(0));
    return octet(0) == 0 ? 0 : 1;
  }
  if (length == 2) give((octet(0) & 0x1FU) << 6U | (octet(1) & 0x3FU));
  if (length == 3) give((octet(0) & 0x0FU) << 12U | (octet(1) & 0x3FU) << 6U | (octet(2) & 0x3FU));
  if (length < 4) return length;
  if (state == nullptr) return kInvalid;
  const unsigned upper = (octet(0) & 0x07U) << 8U | (octet(1) & 0x3FU) << 2U | (octet(2) & 0x3FU) >> 4U;
  give(0xD800U | (upper - 0x40U));  // 0x10000 is 0x40 of these 1024
  pending = kPending | (octet(2) & 0x0FU) << 6U;
  std::memcpy(state, &pending, sizeof pending);
  return 3;
}

std::FILE* __wrap_fopen(const char* name, const char* mode) {
  return ::_wfopen(overbend::to_utf16(name).c_str(), overbend::to_utf16(mode).c_str());
}

std::FILE* __wrap_fopen64(const char* name, const char* mode) {
  return __wrap_fopen(name, mode);
}
}
