/// Promises between parts of the program, checked in release builds too.
///
/// `require` is for what a caller owes or an invariant guarantees. What the user's input may break belongs to
/// base/diagnostics.h, a method that does not converge to its results. Not for kernels: they are compiled once for each
/// instruction set, and the linker keeps one copy of an inline function.
#pragma once

#include <source_location>
#include <string>

namespace overbend {

/// Throws std::logic_error with the promise and the place in the source that relied on it.
[[noreturn]] void broken_promise(const std::string& promise,
                                 std::source_location where = std::source_location::current());

/// Stops at once where `condition` does not hold; `promise` says what was promised, "the file has been flushed".
inline void require(bool condition, const char* promise, std::source_location where = std::source_location::current()) {
  if (!condition) [[unlikely]] {
    broken_promise(promise, where);
  }
}

}  // namespace overbend
