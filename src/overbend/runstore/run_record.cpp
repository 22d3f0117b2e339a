#include "runstore/run_record.h"

#include <fmt/format.h>

#include <cstdint>

#include "base/isa_names.h"
#include "base/source_digest.h"
#include "base/version.h"

namespace overbend {

std::string text_hash(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3ULL;
  }
  return fmt::format("fnv1a64:{:016x}", hash);
}

std::string compiler_name() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown";
#endif
}

std::string program_identity() {
  return fmt::format("{} (sources {}, {}, {})", kVersion, source_digest(), compiler_name(), enum_name(best_isa()));
}

}  // namespace overbend
