/// Runs several cases at the same time, a thread each: progress, interruption, resuming.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/file_lock.h"
#include "study/run/dynamic_realisation.h"

namespace overbend {

/// One of them.
struct CaseRun {
  std::string name;                              ///< Of its case.
  std::shared_ptr<const PreparedCase> prepared;  ///< May be another for each run.
  std::uint64_t seed = 1;
  std::filesystem::path folder;  ///< Of its results, its own.
  double from = 0.0;             ///< Where it is taken up [s]; the end where it was finished before.
  bool begun_before = false;     ///< There is a checkpoint to go on from, or it is finished.
  bool ended = false;            ///< Well or not, now or before.
  RealisationEnd end{};          ///< Of several without the results, which are in their folders.
};

struct CaseOptions {
  bool resume = false;             ///< Finished runs are kept, begun ones taken up.
  double checkpoint_every = 30.0;  ///< Of each run [s].
  int threads = 0;                 ///< Runs at work at the same time; 0: as many as there are cores.
};

/// Whoever follows the runs. All but begin() is called from several threads.
class CaseWatch {
 public:
  CaseWatch() = default;
  virtual ~CaseWatch() = default;
  CaseWatch(const CaseWatch&) = delete;
  CaseWatch& operator=(const CaseWatch&) = delete;

  /// Whether the runs shall stop, each at a checkpoint. Asked after every row of output.
  virtual bool stop() = 0;
  /// Once, before the first run; those that are `ended` are not run again.
  virtual void begin(const std::vector<CaseRun>& runs);
  /// Run number `run` begins.
  virtual void started(std::size_t run);
  virtual void progress(std::size_t run, const DynamicProgress& at);
  virtual void row(std::size_t run, const std::vector<HistoryColumn>& columns, std::span<const double> values);
  /// With its results, for the last time. Not called for runs that were finished before.
  virtual void ended(std::size_t run, const CaseRun& how);
};

/// Runs all into their folders; what they give does not depend on the number of threads. One that fails does not stop
/// the others. `files` is held while files of results are read or written, for the library below them serves one thread
/// alone. Done when each run has ended, well or not; wrong_input when what is to be resumed is of another input.
RunEnd run_cases(std::vector<CaseRun>& runs, const CaseOptions& options, CaseWatch& watch, FileLock& files);

}  // namespace overbend
