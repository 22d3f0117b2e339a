/// Errors of the engine as exceptions of Python: what is thrown from a function of the module becomes one by its type.
#pragma once

#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/file_lock.h"
#include "statics/solver/statics.h"
#include "study/run/run_ending.h"

namespace overbend {

/// Why there is no equilibrium.
class SolveFault : public std::runtime_error {
 public:
  explicit SolveFault(StaticFailure failure) : std::runtime_error(failure.what), failure_(std::move(failure)) {}
  const StaticFailure& failure() const { return failure_; }

 private:
  StaticFailure failure_;
};

/// A run or a choice that ended otherwise than well.
class EndedRun : public std::runtime_error {
 public:
  explicit EndedRun(RunEnd end) : std::runtime_error(end.why), end_(std::move(end)) {}
  const RunEnd& end() const { return end_; }

 private:
  RunEnd end_;
};

/// overbend.errors.ResultsError; the interpreter's lock must be held.
[[noreturn]] void raise_results_error(const std::string& sentence);
/// Reads files of results, alone with HDF5; what fails there is a ResultsError.
template <class Function>
auto reading_results(Function read) {
  const std::lock_guard hold(hdf5_lock());
  try {
    return read();
  } catch (const std::runtime_error& fault) {
    raise_results_error(fault.what());
  }
}
/// overbend.errors.ControllerError, likewise.
[[noreturn]] void raise_controller_error(const std::string& what, const std::string& where, const std::string& why);

}  // namespace overbend
