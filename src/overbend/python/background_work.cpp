#include "python/background_work.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/interruption.h"

namespace overbend {
namespace {

namespace py = pybind11;

/// Handles signals and calls `report` with the GIL held; returns the exception raised, if any.
std::exception_ptr poll_python(const std::function<void()>& report) {
  const py::gil_scoped_acquire hold;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (report) report();
  } catch (...) {
    return std::current_exception();
  }
  return nullptr;
}

/// Releases the GIL briefly if this thread holds it (while writing HDF5 files), so that the waiting thread can handle
/// signals. No HDF5 call is active then, so other threads may use HDF5.
void yield_interpreter() {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kPause(50);
  static thread_local Clock::time_point last;
  if (Clock::now() - last < kPause || PyGILState_Check() == 0) return;
  { const py::gil_scoped_release free; }
  last = Clock::now();
}

}  // namespace

void run_in_background(const std::function<void()>& work, std::atomic<bool>& stop,
                       const std::function<void()>& report) {
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
      raised = poll_python(report);
      if (raised) stop = true;
      hold.lock();
    }
    hold.unlock();
    worker.join();
  }
  if (raised) std::rethrow_exception(raised);
  if (failed) std::rethrow_exception(failed);
  if (report) report();
}

}  // namespace overbend
