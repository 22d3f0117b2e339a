/// Progress of runs for Python.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <mutex>
#include <vector>

#include "study/run/run_cases.h"

namespace overbend {

/// Progress of a run.
struct ReportedProgress {
  double time = 0.0, end = 0.0;  ///< [s]
  double top_tension = 0.0;      ///< [N]
};

/// Collects the progress reported by the threads of the runs, for the waiting thread, which passes it to Python.
class RunObserver : public CaseObserver {
 public:
  bool stop() override { return stopped; }
  void begin(const std::vector<CaseRun>& runs) override;
  void progress(std::size_t run, const DynamicProgress& state) override;
  void ended(std::size_t run, const CaseRun& how) override;

  /// Calls progress(runs done, runs, time, end, top tension); the last three are those of the slowest run.
  void report_progress(const pybind11::object& progress);

  std::atomic<bool> stopped = false;

 private:
  std::mutex mutex_;
  std::vector<ReportedProgress> progress_;
  std::vector<char> done_;
};

}  // namespace overbend
