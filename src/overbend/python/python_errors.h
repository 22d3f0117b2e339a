/// Translation of C++ exceptions of the engine to Python exceptions, by type.
#pragma once

#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/file_lock.h"
#include "statics/solver/statics.h"
#include "study/run/run_status.h"

namespace overbend {

/// Thrown if there is no equilibrium.
class SolveError : public std::runtime_error {
 public:
  explicit SolveError(StaticFailure failure) : std::runtime_error(failure.what), failure_(std::move(failure)) {}
  const StaticFailure& failure() const { return failure_; }

 private:
  StaticFailure failure_;
};

/// Thrown if a run or a choice did not succeed.
class EndedRun : public std::runtime_error {
 public:
  explicit EndedRun(RunResult end) : std::runtime_error(end.why), end_(std::move(end)) {}
  const RunResult& end() const { return end_; }

 private:
  RunResult end_;
};

/// Raises overbend.errors.ResultsError; the GIL must be held.
[[noreturn]] void raise_results_error(const std::string& sentence);
/// Calls `read` with the HDF5 lock held; errors become a ResultsError.
template <class Function>
auto reading_results(Function read) {
  const std::lock_guard hold(hdf5_lock());
  try {
    return read();
  } catch (const std::runtime_error& error) {
    raise_results_error(error.what());
  }
}
/// Raises overbend.errors.ControllerError; the GIL must be held.
[[noreturn]] void raise_controller_error(const std::string& what, const std::string& where, const std::string& why);

}  // namespace overbend
