/// Work in a child process, for libraries that crash on damaged files: the crash becomes an error.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

#include "platform/process_copy.h"

namespace overbend {

/// Limits of a child process. The wall time bounds a process that waits forever, also on a machine under load.
struct ChildLimits {
  std::chrono::seconds cpu_time{10}, wall_time{120};
  std::size_t memory = std::size_t{1} << 30U;  ///< In addition to the current memory of the process [bytes].
};

/// Child process that ended without a result; what() is the reason: "reading it ended with signal 11".
class ChildError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A copy of this process (fork) that does the work and returns its bytes through a pipe; it changes nothing else here.
/// The caller holds the locks of the libraries that the work uses until the constructor returns. Without fork (Windows,
/// WebAssembly) the constructor does the work in this process.
class ChildWork {
 public:
  ChildWork(const std::function<std::string()>& work, const ChildLimits& limits);

  /// Waits for the result of `work`. Throws std::runtime_error with its message if it threw, ChildError if it did not
  /// finish, and what check_interruption() throws.
  std::string result();

 private:
  [[noreturn]] void throw_end_reason();

  std::chrono::steady_clock::time_point until_;
  std::error_code error_;
  ProcessCopy process_;
  std::string received_;
};

}  // namespace overbend
