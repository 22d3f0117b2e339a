#include "python/without_lock.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/interruption.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// With the lock: what Python's signals and `tell` raise.
std::exception_ptr look(const std::function<void()>& tell) {
  const py::gil_scoped_acquire hold;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (tell) tell();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

/// Where this thread holds the interpreter's lock, for it writes files with HDF5, the one that waits shall see its
/// signals now and then. HDF5 is between two calls, so that others may use it meanwhile.
void yield_interpreter() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kPause(50);
  static thread_local Clock::time_point last;
  if (Clock::now() - last < kPause || PyGILState_Check() == 0) return;
  { const py::gil_scoped_release free; }
  last = Clock::now();
}

}  // namespace

void work_beside(const std::function<void()>& work, std::atomic<bool>& stop, const std::function<void()>& tell) {
  constexpr std::chrono::milliseconds kPatience(100);
  std::exception_ptr raised, failed;
  {
    const py::gil_scoped_release free;
    std::mutex mutex;
    std::condition_variable wake;
    bool done = false;
    std::thread worker([&] {
      const InterruptionScope scope([&stop] {
        yield_interpreter();
        return stop.load();
      });
      try {
        work();
      } catch (...) {
        failed = std::current_exception();
      }
      const std::lock_guard<std::mutex> hold(mutex);
      done = true;
      wake.notify_all();
    });
    std::unique_lock<std::mutex> hold(mutex);
    while (!wake.wait_for(hold, kPatience, [&] { return done; })) {
      if (raised) continue;
      hold.unlock();
      raised = look(tell);
      if (raised) stop = true;
      hold.lock();
    }
    hold.unlock();
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (failed) std::rethrow_exception(failed);
  if (tell) tell();
}

}  // namespace overbend
