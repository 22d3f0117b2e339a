#include "app/study_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "app/interruption.h"
#include "app/progress.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

/// Progress of all runs together, reported by several threads. All runs have the same duration.
class StudyProgressPrinter : public CaseObserver {
 public:
  StudyProgressPrinter(std::string noun, bool resume) : noun_(std::move(noun)), resume_(resume) {}

  bool stop() override { return Interruption::wanted(); }

  void begin(const std::vector<CaseRun>& runs) override {
    const DynamicSettings& settings = *runs.front().prepared->description.dynamics;
    before_ = settings.build_up;
    total_time_ = before_ + settings.duration;
    for (const CaseRun& run : runs) times_.push_back(before_ + run.from);
    if (runs.size() == 1) report_start(runs.front());
    progress_.emplace(0.0, total_time_ * static_cast<double>(runs.size()));
  }

  void progress(std::size_t run, const DynamicProgress& state) override {
    const std::lock_guard<std::mutex> hold(mutex_);
    times_[run] = std::min(before_ + state.time, total_time_);
    double sum = 0.0;
    for (const double time : times_) sum += time;
    progress_->show(sum, times_.size() == 1 ? progress_text(state) : progress_text());
  }

 private:
  void report_start(const CaseRun& run) const {
    if (!resume_ || run.ended) return;
    std::cerr << (run.started_before
                      ? fmt::format("Continuing from t = {:.1f} s.\n", run.from)
                      : fmt::format("There is no unfinished run in {}: starting a new one.\n", run.folder.string()));
  }

  static std::string progress_text(const DynamicProgress& state) {
    const std::string time = fmt::format("t = {:.1f} s", state.time);
    return state.top_tension == 0.0 ? time : time + "  tension " + shown(state.top_tension, "N", 1);
  }

  std::string progress_text() const {
    const auto done = std::count_if(times_.begin(), times_.end(), [&](double time) { return time >= total_time_; });
    return fmt::format("{} of {} {} done", done, times_.size(), noun_);
  }

  std::string noun_;
  bool resume_;
  std::mutex mutex_;                        ///< Guards the members below.
  double before_ = 0.0, total_time_ = 0.0;  ///< [s]
  std::vector<double> times_;               ///< Time of each run from the start of the build-up [s].
  std::optional<Progress> progress_;
};

}  // namespace

StudyOutcome follow_study(const Description& base, const StudyPlan& plan, const std::filesystem::path& folder,
                          const CaseOptions& options, const std::string& noun) {
  const Interruption interruption;
  StudyProgressPrinter watch(noun, options.resume);
  return run_study(base, plan, folder, options, watch, hdf5_lock());
}

}  // namespace overbend
