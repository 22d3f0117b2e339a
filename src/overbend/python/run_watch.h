/// Runs followed from Python.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <mutex>
#include <vector>

#include "study/run/run_cases.h"

namespace overbend {

/// How far a run is.
struct RunTold {
  double time = 0.0, end = 0.0;  ///< [s]
  double top_tension = 0.0;      ///< [N]
};

/// Keeps what the threads of the runs tell, for the thread that waits to hand it on to Python.
class RunWatch : public CaseWatch {
 public:
  bool stop() override { return stopped; }
  void begin(const std::vector<CaseRun>& runs) override;
  void progress(std::size_t run, const DynamicProgress& at) override;
  void ended(std::size_t run, const CaseRun& how) override;

  /// Calls progress(runs done, runs, time, end, top tension), the last three of the run that is behind the others.
  void tell(const pybind11::object& progress);

  std::atomic<bool> stopped = false;

 private:
  std::mutex mutex_;
  std::vector<RunTold> at_;
  std::vector<char> done_;
};

}  // namespace overbend
