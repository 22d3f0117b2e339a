/// Work in a copy of this process.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <system_error>

namespace overbend {

struct ProcessLimits {
  std::chrono::seconds cpu_time{0};
  std::size_t memory = 0;  ///< In addition to the current memory of the process [bytes].
};

/// Reason for the end of a process; all members are zero if it ended by itself.
struct ProcessEnd {
  int signal = 0;            ///< Signal that ended it, or 0.
  bool out_of_time = false;  ///< True if it used up its CPU time.
};

/// A copy of this process (fork) that does the work and returns its bytes through a pipe. It has the default handling
/// of signals, ignores Ctrl-C, and ends with this process. Without fork (Windows, WebAssembly) the constructor does the
/// work in this process and without limits.
class ProcessCopy {
 public:
  /// `work` must not throw. If no process can be started, `error` is set and no function but the destructor may be
  /// called.
  ProcessCopy(const std::function<std::string()>& work, const ProcessLimits& limits, std::error_code& error);
  /// Ends the process if it still runs.
  ~ProcessCopy();
  ProcessCopy(const ProcessCopy&) = delete;
  ProcessCopy& operator=(const ProcessCopy&) = delete;

  enum class Arrival { none, bytes, end };
  /// Waits for bytes and appends them to `text`; `none` after `patience`, `end` after the last.
  Arrival read(std::string& text, std::chrono::milliseconds patience);

  /// Waits for the end of the process.
  ProcessEnd wait();

 private:
  int process_ = -1, pipe_ = -1;
  std::string bytes_;  ///< Without fork: bytes that have not been read.
};

}  // namespace overbend
