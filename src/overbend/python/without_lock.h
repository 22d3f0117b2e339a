/// Work of the engine while other threads of Python go on.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <optional>

namespace overbend {

/// Calls without the interpreter's lock.
template <class Function>
auto without_lock(Function make) {
  const pybind11::gil_scoped_release free;
  return make();
}

/// Calls `work` in a thread that Python does not know, so that taking the interpreter's lock within it is cheap: what
/// Python keeps of the thread is made once.
template <class Function>
void work_with_calls(Function work) {
  const pybind11::gil_scoped_acquire known;
  const pybind11::gil_scoped_release free;
  work();
}

/// Does `work` in a thread of its own, without the interpreter's lock. This one waits, ten times a second lets Python
/// see its signals and calls `tell` with the lock. Where either raises, `stop` becomes true, the end of the work is
/// awaited, and the exception is thrown: KeyboardInterrupt after Ctrl-C. Exceptions of the work are thrown here. `stop`
/// also interrupts the work where it asks (base/interruption.h).
void work_beside(const std::function<void()>& work, std::atomic<bool>& stop, const std::function<void()>& tell);

/// What `make` gives, for what may take longer than a moment: Ctrl-C ends it.
template <class Function>
auto interruptible(Function make) {
  std::optional<decltype(make())> made;
  std::atomic<bool> stop = false;
  work_beside([&] { made.emplace(make()); }, stop, {});
  return std::move(*made);
}

}  // namespace overbend
