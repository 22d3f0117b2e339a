/// Computations without the GIL, so that other Python threads continue.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <functional>
#include <optional>

namespace overbend {

/// Calls `make` without the GIL.
template <class Function>
auto without_lock(Function make) {
  const pybind11::gil_scoped_release free;
  return make();
}

/// Calls `work` in a thread not created by Python. Registers the thread state with Python once, so that acquiring the
/// GIL within `work` is cheap.
template <class Function>
void run_with_gil_calls(Function work) {
  const pybind11::gil_scoped_acquire known;
  const pybind11::gil_scoped_release free;
  work();
}

/// Runs `work` in a separate thread without the GIL. The calling thread waits and, ten times per second, lets Python
/// handle signals and calls `report` with the GIL held. If either raises, sets `stop`, waits for the end of the work
/// and throws the exception (KeyboardInterrupt after Ctrl-C). Exceptions of the work are rethrown. `stop` also
/// interrupts the work where it polls (base/interruption.h).
void run_in_background(const std::function<void()>& work, std::atomic<bool>& stop, const std::function<void()>& report);

/// Returns the result of `make`, which may take long and can be interrupted by Ctrl-C.
template <class Function>
auto interruptible(Function make) {
  std::optional<decltype(make())> made;
  std::atomic<bool> stop = false;
  run_in_background([&] { made.emplace(make()); }, stop, {});
  return std::move(*made);
}

}  // namespace overbend
