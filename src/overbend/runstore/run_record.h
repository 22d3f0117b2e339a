/// Origin of results, which makes a run traceable.
#pragma once

#include <string>

namespace overbend {

/// FNV-1a, 64 bit, as "fnv1a64:" and 16 hexadecimal digits. Distinguishes texts; no protection against intent.
std::string text_hash(const std::string& text);

/// Compiler and its version.
std::string compiler_name();

/// Identity of the program: version, digest of the sources that take part in computing, compiler and instruction set.
/// Two programs of the same identity give the same bits.
std::string program_identity();

}  // namespace overbend
