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

/// Checked again because another command may have written into the folder since.
bool has_stored_results(const CaseRun& run) {
  const std::filesystem::path h5 = run.folder / "results.h5";
  return is_finished(run.folder, run.prepared->input) && std::filesystem::exists(h5) && has_dynamic(h5);
}

/// Reads the state of an earlier run. Throws std::runtime_error if that has another input.
void load_earlier_run(CaseRun& run) {
  if (has_stored_results(run)) {
    run.started_before = run.ended = true;
    run.from = settings(run).duration;
  } else if (const auto begun = RunStore::resume(run.folder, run.prepared->input, run.seed)) {
    run.started_before = true;
    run.from = begun->state.time;
  }
}

/// Stores the stage of the run, which resuming needs.
void keep_stage(const CaseRun& run) {
  const std::optional<LayStageDescription>& stage = run.prepared->description.stage;
  const std::string name = stage ? stage->name : "";
  if (name.empty() && !read_record(run.folder)) return;
  std::error_code error;  // the run reports a folder that cannot be created
  std::filesystem::create_directories(run.folder, error);
  if (!error) change_record(run.folder, [&](RunRecord& record) { record.stage = name; });
}

/// Shared work of the threads.
class CaseWork {
 public:
  CaseWork(std::vector<CaseRun>& runs, const CaseOptions& options, CaseObserver& watch, FileLock& files)
      : runs_(runs), options_(options), watch_(watch), files_(files) {}

  void go() {
    work_in_threads(useful_threads(options_.threads, runs_.size()), [this] { work(); });
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < runs_.size() && !watch_.stop(); i = next_++) {
      CaseRun& case_run = runs_[i];
      if (case_run.ended) continue;
      watch_.started(i);
      case_run.end = run(i);
      case_run.ended = case_run.end.ending != RunStatus::interrupted;
      watch_.ended(i, case_run);
      if (runs_.size() > 1) case_run.end.results.reset();  // several results would exceed the memory
    }
  }

  /// Errors of this run only; the others continue.
  RealisationResult run(std::size_t index) {
    try {
      return try_run(index);
    } catch (const FileError& error) {
      return {{RunStatus::error, error.what()}};
    } catch (const UnusableFolder& error) {
      return {{RunStatus::error, error.what()}};
    } catch (const Interrupted&) {
      return {{RunStatus::interrupted, "interrupted"}};
    } catch (const std::exception& error) {
      return {{RunStatus::error, std::string("internal error: ") + error.what()}};
    }
  }

  RealisationResult try_run(std::size_t index) {
    const CaseRun& case_run = runs_[index];
    SteadyClock::time_point last = SteadyClock::now();
    const auto control = [&](const DynamicProgress& progress) {
      watch_.progress(index, progress);
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
    if (!options_.resume) mark_unfinished(case_run.folder);
    keep_stage(case_run);
    RealisationResult end =
        run_realisation(*case_run.prepared, case_run.folder, case_run.seed, options_.resume, control, files_, rows);
    if (end.ending == RunStatus::done) {
      const std::lock_guard hold(files_);
      mark_finished(case_run.folder, "dynamic", case_run.prepared->statics.title, case_run.prepared->input);
    }
    return end;
  }

  std::vector<CaseRun>& runs_;
  const CaseOptions& options_;
  CaseObserver& watch_;
  FileLock& files_;
  std::atomic<std::size_t> next_{0};
};

}  // namespace

void CaseObserver::begin(const std::vector<CaseRun>& /*runs*/) {}
void CaseObserver::started(std::size_t /*run*/) {}
void CaseObserver::progress(std::size_t /*run*/, const DynamicProgress& /*at*/) {}
void CaseObserver::row(std::size_t /*run*/, const std::vector<HistoryColumn>& /*columns*/,
                       std::span<const double> /*values*/) {}
void CaseObserver::ended(std::size_t /*run*/, const CaseRun& /*how*/) {}

RunResult run_cases(std::vector<CaseRun>& runs, const CaseOptions& options, CaseObserver& watch, FileLock& files) {
  for (std::size_t i = 1; i < runs.size(); ++i) {
    require(runs[i].prepared != runs[i - 1].prepared || runs[i].prepared->controllers.empty(),
            "controllers keep state and can drive one run only");
  }
  for (CaseRun& run : runs) run.from = -settings(run).build_up;
  if (options.resume) {
    try {
      const std::lock_guard hold(files);
      for (CaseRun& run : runs) load_earlier_run(run);
    } catch (const std::runtime_error& error) {
      return {RunStatus::wrong_input, error.what()};
    }
  }
  watch.begin(runs);
  CaseWork(runs, options, watch, files).go();
  const bool all = std::all_of(runs.begin(), runs.end(), [](const CaseRun& run) { return run.ended; });
  return all ? RunResult{} : RunResult{RunStatus::interrupted, "interrupted"};
}

}  // namespace overbend
