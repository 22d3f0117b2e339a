#include "python/run_observer.h"

#include <algorithm>

#include "base/ranges.h"

namespace overbend {

void RunObserver::begin(const std::vector<CaseRun>& runs) {
  const std::lock_guard<std::mutex> hold(mutex_);
  progress_.assign(runs.size(), {});
  done_.assign(runs.size(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i) done_[i] = runs[i].ended ? 1 : 0;
}

void RunObserver::progress(std::size_t run, const DynamicProgress& state) {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (run >= progress_.size()) {
    progress_.resize(run + 1);
    done_.resize(run + 1);
  }
  progress_[run] = {state.time, state.end, state.top_tension};
}

void RunObserver::ended(std::size_t run, const CaseRun& /*how*/) {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (run < done_.size()) done_[run] = 1;
}

void RunObserver::report_progress(const pybind11::object& progress) {
  if (progress.is_none()) return;
  ReportedProgress behind;
  std::size_t done = 0, runs = 0;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    runs = progress_.size();
    done = static_cast<std::size_t>(ranges::count(done_, 1));
    bool found = false;
    for (std::size_t i = 0; i < runs; ++i) {
      if (progress_[i].end <= 0.0 || (done_[i] != 0 && done < runs)) continue;
      if (!found || progress_[i].time < behind.time) behind = progress_[i];
      found = true;
    }
    if (!found) return;
  }
  progress(done, runs, behind.time, behind.end, behind.top_tension);
}

}  // namespace overbend
