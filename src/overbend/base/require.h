/// Promises between parts of the program, checked in release builds too.
///
/// `require` is for what a caller owes or an invariant guarantees. What the user's input may break belongs to
/// base/diagnostics.h, a method that does not converge to its results. Not for kernels: they are compiled once for each
/// instruction set, and the linker keeps one copy of an inline function.
#pragma once

#include <string>

namespace overbend {

/// Throws std::logic_error with the promise and the place in the source that relied on it.
[[noreturn]] void broken_promise(const std::string& promise, const char* file = __builtin_FILE(),
                                 int line = __builtin_LINE());

/// Stops at once where `condition` does not hold; `promise` says what was promised, "the file has been flushed".
inline void require(bool condition, const char* promise, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE()) {
  if (!condition) [[unlikely]] {
    broken_promise(promise, file, line);
  }
}

}  // namespace overbend
