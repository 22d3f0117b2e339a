#include "study/run/run_cases.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include "base/interruption.h"
#include "base/require.h"
#include "base/threads.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "runstore/append_file.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"
#include "study/run/run_folder.h"

namespace overbend {
namespace {

using SteadyClock = std::chrono::steady_clock;

const DynamicSettings& settings(const CaseRun& run) {
  return *run.prepared->description.dynamics;
}

/// Another command may have written into the folder since.
bool has_its_results(const CaseRun& run) {
  const std::filesystem::path h5 = run.folder / "results.h5";
  return is_finished(run.folder, run.prepared->input) && std::filesystem::exists(h5) && has_dynamic(h5);
}

/// What was left of a run before. Throws std::runtime_error where that is of another input.
void look_back(CaseRun& run) {
  if (has_its_results(run)) {
    run.begun_before = run.ended = true;
    run.from = settings(run).duration;
  } else if (const auto begun = RunStore::resume(run.folder, run.prepared->input, run.seed)) {
    run.begun_before = true;
    run.from = begun->state.time;
  }
}

/// What a run in that folder is of has to be known when it is resumed.
void keep_stage(const CaseRun& run) {
  const std::optional<LayStageDescription>& stage = run.prepared->description.stage;
  const std::string name = stage ? stage->name : "";
  if (name.empty() && !read_record(run.folder)) return;
  std::error_code fault;  // a folder that cannot be is told by the run
  std::filesystem::create_directories(run.folder, fault);
  if (!fault) change_record(run.folder, [&](RunRecord& record) { record.stage = name; });
}

/// The threads' common work.
class CaseWork {
 public:
  CaseWork(std::vector<CaseRun>& runs, const CaseOptions& options, CaseWatch& watch, FileLock& files)
      : runs_(runs), options_(options), watch_(watch), files_(files) {}

  void go() {
    work_in_threads(useful_threads(options_.threads, runs_.size()), [this] { work(); });
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < runs_.size() && !watch_.stop(); i = next_++) {
      CaseRun& one = runs_[i];
      if (one.ended) continue;
      watch_.started(i);
      one.end = run(i);
      one.ended = one.end.ending != RunEnding::interrupted;
      watch_.ended(i, one);
      if (runs_.size() > 1) one.end.results.reset();  // of many there is not memory enough
    }
  }

  /// This one's disk or numbers; the others go on.
  RealisationEnd run(std::size_t index) {
    try {
      return try_run(index);
    } catch (const FileFault& fault) {
      return {{RunEnding::fault, fault.what()}};
    } catch (const UnusableFolder& fault) {
      return {{RunEnding::fault, fault.what()}};
    } catch (const Interrupted&) {
      return {{RunEnding::interrupted, "interrupted"}};
    } catch (const std::exception& fault) {
      return {{RunEnding::fault, std::string("internal fault: ") + fault.what()}};
    }
  }

  RealisationEnd try_run(std::size_t index) {
    const CaseRun& one = runs_[index];
    SteadyClock::time_point last = SteadyClock::now();
    const auto control = [&](const DynamicProgress& at) {
      watch_.progress(index, at);
      if (watch_.stop()) return DynamicControl::stop;
      if (std::chrono::duration<double>(SteadyClock::now() - last).count() < options_.checkpoint_every) {
        return DynamicControl::go_on;
      }
      last = SteadyClock::now();
      return DynamicControl::checkpoint;
    };
    const auto rows = [&](const std::vector<HistoryColumn>& columns, std::span<const double> values) {
      watch_.row(index, columns, values);
    };
    if (!options_.resume) unmark(one.folder);
    keep_stage(one);
    RealisationEnd end = run_realisation(*one.prepared, one.folder, one.seed, options_.resume, control, files_, rows);
    if (end.ending == RunEnding::done) {
      const std::lock_guard hold(files_);
      mark_finished(one.folder, "dynamic", one.prepared->statics.title, one.prepared->input);
    }
    return end;
  }

  std::vector<CaseRun>& runs_;
  const CaseOptions& options_;
  CaseWatch& watch_;
  FileLock& files_;
  std::atomic<std::size_t> next_{0};
};

}  // namespace

void CaseWatch::begin(const std::vector<CaseRun>& /*runs*/) {}
void CaseWatch::started(std::size_t /*run*/) {}
void CaseWatch::progress(std::size_t /*run*/, const DynamicProgress& /*at*/) {}
void CaseWatch::row(std::size_t /*run*/, const std::vector<HistoryColumn>& /*columns*/,
                    std::span<const double> /*values*/) {}
void CaseWatch::ended(std::size_t /*run*/, const CaseRun& /*how*/) {}

RunEnd run_cases(std::vector<CaseRun>& runs, const CaseOptions& options, CaseWatch& watch, FileLock& files) {
  for (std::size_t i = 1; i < runs.size(); ++i) {
    require(runs[i].prepared != runs[i - 1].prepared || runs[i].prepared->controllers.empty(),
            "controllers, which remember, drive one run alone");
  }
  for (CaseRun& run : runs) run.from = -settings(run).build_up;
  if (options.resume) {
    try {
      const std::lock_guard hold(files);
      for (CaseRun& run : runs) look_back(run);
    } catch (const std::runtime_error& fault) {
      return {RunEnding::wrong_input, fault.what()};
    }
  }
  watch.begin(runs);
  CaseWork(runs, options, watch, files).go();
  const bool all = std::all_of(runs.begin(), runs.end(), [](const CaseRun& run) { return run.ended; });
  return all ? RunEnd{} : RunEnd{RunEnding::interrupted, "interrupted"};
}

}  // namespace overbend
