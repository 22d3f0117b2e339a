/// Preconditions and invariants, checked in release builds too.
///
/// `require` is for preconditions of callers and invariants. Errors in the user's input belong to base/diagnostics.h, a
/// method that does not converge to its results. Not for kernels: they are compiled once for each instruction set, and
/// the linker keeps one copy of an inline function.
#pragma once

#include <string>

namespace overbend {

/// Throws std::logic_error with the violated condition and its location in the source.
[[noreturn]] void broken_promise(const std::string& promise, const char* file = __builtin_FILE(),
                                 int line = __builtin_LINE());

/// Throws std::logic_error if `condition` is false; `promise` states the condition: "the file has been flushed".
inline void require(bool condition, const char* promise, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE()) {
  if (!condition) [[unlikely]] {
    broken_promise(promise, file, line);
  }
}

}  // namespace overbend
