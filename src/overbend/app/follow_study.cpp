#include "app/follow_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <optional>

#include "app/interruption.h"
#include "app/progress.h"
#include "base/shown_unit.h"

namespace overbend {
namespace {

/// Progress of all runs together, told by several threads. They are of one length.
class FollowedStudy : public CaseWatch {
 public:
  FollowedStudy(std::string noun, bool resume) : noun_(std::move(noun)), resume_(resume) {}

  bool stop() override { return Interruption::wanted(); }

  void begin(const std::vector<CaseRun>& runs) override {
    const DynamicSettings& settings = *runs.front().prepared->description.dynamics;
    before_ = settings.build_up;
    whole_ = before_ + settings.duration;
    for (const CaseRun& run : runs) at_.push_back(before_ + run.from);
    if (runs.size() == 1) tell_beginning(runs.front());
    progress_.emplace(0.0, whole_ * static_cast<double>(runs.size()));
  }

  void progress(std::size_t run, const DynamicProgress& at) override {
    const std::lock_guard<std::mutex> hold(mutex_);
    at_[run] = std::min(before_ + at.time, whole_);
    double sum = 0.0;
    for (const double one : at_) sum += one;
    progress_->show(sum, at_.size() == 1 ? words(at) : words());
  }

 private:
  void tell_beginning(const CaseRun& run) const {
    if (!resume_ || run.ended) return;
    std::cerr << (run.begun_before
                      ? fmt::format("Continuing from t = {:.1f} s.\n", run.from)
                      : fmt::format("There is no unfinished run in {}: starting a new one.\n", run.folder.string()));
  }

  static std::string words(const DynamicProgress& at) {
    const std::string time = fmt::format("t = {:.1f} s", at.time);
    return at.top_tension == 0.0 ? time : time + "  tension " + shown(at.top_tension, "N", 1);
  }

  std::string words() const {
    const auto done = std::count_if(at_.begin(), at_.end(), [&](double at) { return at >= whole_; });
    return fmt::format("{} of {} {} done", done, at_.size(), noun_);
  }

  std::string noun_;
  bool resume_;
  std::mutex mutex_;                   ///< Of what follows.
  double before_ = 0.0, whole_ = 0.0;  ///< [s]
  std::vector<double> at_;             ///< From the beginning of the build-up [s].
  std::optional<Progress> progress_;
};

}  // namespace

StudyEnd follow_study(const Description& base, const StudyPlan& plan, const std::filesystem::path& folder,
                      const CaseOptions& options, const std::string& noun) {
  const Interruption interruption;
  FollowedStudy watch(noun, options.resume);
  return run_study(base, plan, folder, options, watch, hdf5_lock());
}

}  // namespace overbend
