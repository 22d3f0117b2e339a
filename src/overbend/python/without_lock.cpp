#include "python/without_lock.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

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
