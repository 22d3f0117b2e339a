/// Runs several cases concurrently, one thread each, with progress, interruption and resuming.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "study/run/dynamic_realisation.h"

namespace overbend {

/// One run of the batch.
struct CaseRun {
  std::string name;                              ///< Name of its case.
  std::shared_ptr<const PreparedCase> prepared;  ///< May differ from run to run.
  std::uint64_t seed = 1;
  std::filesystem::path folder;  ///< Folder of its results, not shared.
  double from = 0.0;             ///< Time from which it is resumed [s]; the end of the run if it was finished before.
  bool started_before = false;   ///< True if there is a checkpoint to resume from, or it is finished.
  bool ended = false;            ///< True if it has ended, successfully or not, now or before.
  RealisationResult end{};       ///< Result; of several runs without the results, which are in their folders.
};

struct CaseOptions {
  bool resume = false;             ///< Finished runs are kept, started ones resumed.
  double checkpoint_every = 30.0;  ///< Interval of the checkpoints of each run [s].
  int threads = 0;                 ///< Number of concurrent runs; 0: the number of cores.
};

/// Observer of the runs. All functions but begin() are called from several threads.
class CaseObserver {
 public:
  CaseObserver() = default;
  virtual ~CaseObserver() = default;
  CaseObserver(const CaseObserver&) = delete;
  CaseObserver& operator=(const CaseObserver&) = delete;

  /// True if the runs shall stop, each at a checkpoint. Called after every output row.
  virtual bool stop() = 0;
  /// True to abandon also what leaves no checkpoint: statics, files that are written. By default like stop().
  virtual bool abandon() { return stop(); }
  /// Called once before the first run; runs that are `ended` are not repeated.
  virtual void begin(const std::vector<CaseRun>& runs);
  /// Called when run number `run` starts.
  virtual void started(std::size_t run);
  /// Called after every output row of a run.
  virtual void progress(std::size_t run, const DynamicProgress& progress);
  /// Called with the columns and values of every output row of a run.
  virtual void row(std::size_t run, const std::vector<HistoryColumn>& columns, std::span<const double> values);
  /// Called once at the end, with the results. Not called for runs that were finished before.
  virtual void ended(std::size_t run, const CaseRun& how);
};

/// Runs all cases into their folders; the results do not depend on the number of threads. A failed run does not stop
/// the others. `files` is held while files of results are read or written, because the library below serves one thread
/// only. Returns done when each run has ended, successfully or not; wrong_input if what is to be resumed has another
/// input.
RunResult run_cases(std::vector<CaseRun>& runs, const CaseOptions& options, CaseObserver& watch, FileLock& files);

}  // namespace overbend
