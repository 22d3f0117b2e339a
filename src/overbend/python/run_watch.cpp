#include "python/run_watch.h"

#include <algorithm>

namespace overbend {

void RunWatch::begin(const std::vector<CaseRun>& runs) {
  const std::lock_guard<std::mutex> hold(mutex_);
  at_.assign(runs.size(), {});
  done_.assign(runs.size(), 0);
  for (std::size_t i = 0; i < runs.size(); ++i) done_[i] = runs[i].ended ? 1 : 0;
}

void RunWatch::progress(std::size_t run, const DynamicProgress& at) {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (run >= at_.size()) {
    at_.resize(run + 1);
    done_.resize(run + 1);
  }
  at_[run] = {at.time, at.end, at.top_tension};
}

void RunWatch::ended(std::size_t run, const CaseRun& /*how*/) {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (run < done_.size()) done_[run] = 1;
}

void RunWatch::tell(const pybind11::object& progress) {
  if (progress.is_none()) return;
  RunTold behind;
  std::size_t done = 0, runs = 0;
  {
    const std::lock_guard<std::mutex> hold(mutex_);
    runs = at_.size();
    done = static_cast<std::size_t>(std::ranges::count(done_, 1));
    bool found = false;
    for (std::size_t i = 0; i < runs; ++i) {
      if (at_[i].end <= 0.0 || (done_[i] != 0 && done < runs)) continue;
      if (!found || at_[i].time < behind.time) behind = at_[i];
      found = true;
    }
    if (!found) return;
  }
  progress(done, runs, behind.time, behind.end, behind.top_tension);
}

}  // namespace overbend
