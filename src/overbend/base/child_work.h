/// Work in a process of its own, for libraries that do not survive damaged files: there a crash is an error as any
/// other.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace overbend {

/// What a piece of work may use. The wall time is for a machine under load, and for work that waits for ever.
struct ChildLimits {
  std::chrono::seconds cpu_time{10}, wall_time{120};
  std::size_t memory = std::size_t{1} << 30U;  ///< In addition to what the process has already [bytes].
};

/// Work that ended without a result; what() says how: "the process that read it was ended by signal 11".
class ChildFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A copy of this process (fork) that does the work and hands its bytes back; nothing else of what it does comes back.
/// The thread that makes one has to hold the locks of what the work uses until the constructor returns, and no other
/// thread is in the copy. Where the system has no fork (Windows, WebAssembly), the work is done by the constructor.
class ChildWork {
 public:
  ChildWork(const std::function<std::string()>& work, const ChildLimits& limits);
  /// Ends the process if it still runs.
  ~ChildWork();
  ChildWork(const ChildWork&) = delete;
  ChildWork& operator=(const ChildWork&) = delete;

  /// Waits for what `work` returned. Throws std::runtime_error with its words where it threw, ChildFault where it did
  /// not come to an end, and what check_interruption() throws.
  std::string result();

 private:
  [[noreturn]] void refuse();
  int end();

  std::chrono::steady_clock::time_point until_;
  int pid_ = -1, pipe_ = -1;
  std::string received_;
};

}  // namespace overbend
