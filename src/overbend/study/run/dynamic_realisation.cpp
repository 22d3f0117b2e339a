#include "study/run/dynamic_realisation.h"

#include <stdexcept>

#include "base/interruption.h"
#include "checks/run_checks.h"
#include "report/report.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"
#include "study/run/history_statistics.h"
#include "study/run/motion_statistics.h"
#include "study/run/run_findings.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Store of the run's data, and the state to resume from.
struct StartedRun {
  RunStore store;
  std::optional<DynamicCheckpoint> state;
};

StartedRun begin(const fs::path& folder, const std::string& input, std::uint64_t seed, bool resume) {
  if (resume) {
    if (std::optional<ResumedRun> resumed = RunStore::resume(folder, input, seed)) {
      return {std::move(resumed->store), std::move(resumed->state)};
    }
  }
  return {RunStore::create(folder, input, seed), std::nullopt};
}

void write_results(const PreparedCase& shared, const DynamicResults& results, const RunStore& store,
                   const fs::path& folder) {
  StagedFolder staged(folder);
  write_dynamic_files(shared.statics, results, store, shared.description, staged.path());
  write_report(shared.statics, results, shared.description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

/// Passes everything on to the store, and rows also to the observer.
class ObservedStore : public DynamicSink {
 public:
  ObservedStore(RunStore& store, const RowCallback& rows) : store_(store), rows_(rows) {}

  void begin(const std::vector<HistoryColumn>& columns, const SnapshotSize& size) override {
    store_.begin(columns, size);
  }
  void row(std::span<const double> values) override {
    store_.row(values);
    if (rows_) rows_(store_.columns(), values);
  }
  void snapshot(double time, std::span<const double> values) override { store_.snapshot(time, values); }
  void impact(const Impact& impact) override { store_.impact(impact); }
  void checkpoint(const DynamicCheckpoint& state) override { store_.checkpoint(state); }

 private:
  RunStore& store_;
  const RowCallback& rows_;
};

}  // namespace

RealisationResult run_realisation(const PreparedCase& shared, const fs::path& folder, std::uint64_t seed, bool resume,
                                  const std::function<DynamicControl(const DynamicProgress&)>& control,
                                  FileLock& writing, const RowCallback& rows, RunFiles files) {
  std::optional<StartedRun> begun;
  try {
    begun.emplace(begin(folder, shared.input, seed, resume));
  } catch (const std::runtime_error& error) {  // the folder cannot be created, or holds a run of another input
    return {{RunStatus::wrong_input, error.what()}};
  }
  DynamicOptions options = dynamic_options(shared.model);
  options.seed = seed;
  options.controllers = shared.controllers;
  DynamicOutcome outcome;
  try {
    ObservedStore sink(begun->store, rows);
    outcome = run_dynamics(shared.model, shared.start, shared.statics, options, sink,
                           begun->state ? &*begun->state : nullptr, control);
  } catch (const std::invalid_argument& error) {  // a sea or a motion that cannot be generated
    begun->store.remove();
    return {{RunStatus::wrong_input, error.what()}};
  } catch (const Interrupted&) {
    if (!begun->state) begun->store.remove();  // stopped before its first step
    return {{RunStatus::interrupted, "interrupted"}};
  }
  if (outcome.stopped) {
    const UninterruptedScope put_away;
    if (!RunStore::find(folder)) begun->store.remove();
    if (outcome.results) fill_checks(shared.model, shared.statics, *outcome.results);
    return {{RunStatus::interrupted, "interrupted"}, {}, std::move(outcome.results)};
  }
  if (outcome.results) fill_checks(shared.model, shared.statics, *outcome.results);
  if (outcome.failure) {
    begun->store.remove();
    return {failure_result(*outcome.failure, shared.description)};
  }
  finish_motions(shared.statics, shared.description, *outcome.results, begun->store);
  finish_histories(shared.description, *outcome.results, begun->store);
  if (files == RunFiles::all) {
    const std::lock_guard hold(writing);
    write_results(shared, *outcome.results, begun->store, folder);
  }
  std::vector<HistoryPeaks> peaks;
  if (files == RunFiles::none) {
    peaks = find_run_peaks(begun->store.columns(), [&](std::size_t i) { return begun->store.column(i); });
  }
  begun->store.remove();
  return {{RunStatus::done}, std::move(peaks), std::move(outcome.results)};
}

void write_partial_results(const PreparedCase& shared, DynamicResults results, const fs::path& folder,
                           FileLock& writing) {
  const UninterruptedScope put_away;
  std::optional<ResumedRun> run = RunStore::resume(folder, shared.input, results.seed);
  if (!run) return;
  finish_motions(shared.statics, shared.description, results, run->store);
  finish_histories(shared.description, results, run->store);
  const std::lock_guard hold(writing);
  write_results(shared, results, run->store, folder);
}

}  // namespace overbend
