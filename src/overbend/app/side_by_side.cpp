#include "app/side_by_side.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iostream>
#include <thread>

#include "app/finished_mark.h"
#include "app/interruption.h"
#include "app/progress.h"
#include "runstore/run_store.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using SteadyClock = std::chrono::steady_clock;

const DynamicSettings& settings(const SideRun& run) {
  return *run.shared->description.dynamics;
}

/// What an earlier sitting left of a run, and where it goes on [s]. Throws std::runtime_error where that is of another
/// input.
double look_back(SideRun& run) {
  const std::string& input = run.shared->input;
  if (is_finished(run.folder, input)) {
    run.ended = true;
    return settings(run).duration;
  }
  const std::optional<ResumedRun> begun = RunStore::resume(run.folder, input, run.seed);
  return begun ? begun->state.time : -settings(run).build_up;
}

/// Progress of all runs together, told by several threads. They are of one length.
class SideProgress {
 public:
  /// `begins`: where each is taken up [s].
  SideProgress(const std::vector<double>& begins, const DynamicSettings& settings, std::string noun)
      : at_(begins),
        before_(settings.build_up),
        whole_(before_ + settings.duration),
        noun_(std::move(noun)),
        progress_(0.0, whole_ * static_cast<double>(begins.size())) {
    for (double& at : at_) at += before_;
  }

  void show(std::size_t index, double time) {
    const std::lock_guard<std::mutex> hold(mutex_);
    at_[index] = std::min(before_ + time, whole_);
    double sum = 0.0;
    for (const double at : at_) sum += at;
    const auto done = std::count_if(at_.begin(), at_.end(), [&](double at) { return at >= whole_; });
    progress_.show(sum, fmt::format("{} of {} {} done", done, at_.size(), noun_));
  }

 private:
  std::mutex mutex_;
  std::vector<double> at_;
  double before_, whole_;
  std::string noun_;
  Progress progress_;
};

/// The threads' common work.
class SideWork {
 public:
  SideWork(const SideOptions& options, std::vector<SideRun>& runs, const std::vector<double>& begins,
           const std::string& noun)
      : options_(options), runs_(runs), progress_(begins, settings(runs.front()), noun) {}

  void go() {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t wanted = options_.threads > 0 ? static_cast<std::size_t>(options_.threads) : cores;
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < std::min(wanted, runs_.size()); ++i) threads.emplace_back([this] { work(); });
    work();
    for (std::thread& thread : threads) thread.join();
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < runs_.size() && !Interruption::wanted(); i = next_++) {
      if (runs_[i].ended) continue;
      runs_[i].end = run(i);
      runs_[i].end.results.reset();
      runs_[i].ended = runs_[i].end.code != kInterrupted;
    }
  }

  RealisationEnd run(std::size_t index) {
    const SideRun& one = runs_[index];
    SteadyClock::time_point last = SteadyClock::now();
    const auto control = [&](const DynamicProgress& at) {
      progress_.show(index, at.time);
      if (Interruption::wanted()) return DynamicControl::stop;
      if (std::chrono::duration<double>(SteadyClock::now() - last).count() < options_.checkpoint_every) {
        return DynamicControl::go_on;
      }
      last = SteadyClock::now();
      return DynamicControl::checkpoint;
    };
    try {
      if (!options_.resume) unmark(one.folder);
      RealisationEnd end = run_realisation(*one.shared, one.folder, one.seed, options_.resume, control, writing_);
      if (end.code == kDone) mark_finished(one.folder, one.shared->input);
      return end;
    } catch (const std::exception& fault) {  // this one's disk or numbers; the others go on
      return {kInternalFault, fault.what(), std::nullopt};
    }
  }

  const SideOptions& options_;
  std::vector<SideRun>& runs_;
  std::atomic<std::size_t> next_{0};
  std::mutex writing_;
  SideProgress progress_;
};

}  // namespace

ExitCode run_side_by_side(std::vector<SideRun>& runs, const SideOptions& options, const std::string& noun) {
  std::vector<double> begins;
  try {
    for (SideRun& run : runs) begins.push_back(options.resume ? look_back(run) : -settings(run).build_up);
  } catch (const std::runtime_error& fault) {
    std::cerr << "overbend: " << fault.what() << "\n";
    return kWrongInput;
  }
  {
    const Interruption interruption;
    SideWork(options, runs, begins, noun).go();
  }
  if (std::all_of(runs.begin(), runs.end(), [](const SideRun& run) { return run.ended; })) return kDone;
  std::cerr << "overbend: interrupted; continue the run with --resume\n";
  return kInterrupted;
}

bool all_wrong(const std::vector<SideRun>& runs, const fs::path& folder) {
  const bool wrong = std::all_of(runs.begin(), runs.end(), [](const SideRun& r) { return r.end.code == kWrongInput; });
  if (!wrong) return false;
  std::cerr << "overbend: " << runs.front().end.why << "\n";
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) fs::remove(folder, ignored);  // where nothing else is in it
  return true;
}

}  // namespace overbend
