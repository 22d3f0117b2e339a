/// Runs the cases of a study concurrently in its folder.
#pragma once

#include <filesystem>
#include <optional>

#include "study/campaign/study_folder.h"

namespace overbend {

struct TrialReport;

struct StudyRunOptions {
  int threads = 0;            ///< 0: the number of cores.
  bool retry_failed = false;  ///< Failed cases are run again.
  std::size_t task = 0,
              tasks = 1;           ///< Only the cases whose number modulo `tasks` is `task` are run.
  double checkpoint_every = 60.0;  ///< Checkpoint interval of dynamic analyses [s].
  bool tables = true;              ///< Tables are written when all cases are run; with several tasks, by a later
                                   ///< gathering.
};

/// Observer of a study. All functions but begin() are called from several threads.
class StudyObserver {
 public:
  StudyObserver() = default;
  virtual ~StudyObserver() = default;
  StudyObserver(const StudyObserver&) = delete;
  StudyObserver& operator=(const StudyObserver&) = delete;

  /// True to stop; dynamic analyses stop at a checkpoint.
  virtual bool stop() = 0;
  /// True to abandon also what leaves no checkpoint: statics, files that are written. By default like stop().
  virtual bool abandon() { return stop(); }
  /// Called once before the first case: numbers of cases to be run and of cases finished before.
  virtual void begin(std::size_t open, std::size_t finished);
  /// Called after every output step of a dynamic analysis, from several threads.
  virtual void advanced();
  /// Called after every case, with its results.
  virtual void ended(const StudyCase& study_case);
  /// Called by a limit search in place of ended(), after each analysis.
  virtual void tried(const TrialReport& trial);
};

/// Numbers of cases by their outcome.
struct StudyTally {
  std::size_t done = 0, failed = 0;  ///< Cases run by this process.
  std::size_t before = 0;            ///< Cases finished before.
  std::size_t elsewhere = 0;         ///< Cases running in other processes.
  bool interrupted = false;
};

/// Runs the cases without a record. The results do not depend on the number of threads or processes, nor on
/// interruptions. Several processes may share the folder: no case is run by two of them. A failed case does not stop
/// the others. Throws FileError if a record cannot be written.
StudyTally run_study_cases(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder,
                           const StudyRunOptions& options, StudyObserver& watch);

/// Runs one case alone, regardless of its record, with all result files in its folder, and records it. If it fails
/// although its record has a result, which another case may have led to, the record stays and the reason says so.
StudyCase run_study_case(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder,
                         std::size_t number, const std::function<bool()>& stop);

/// Reads all records in the folder, with extremes over seeds. Throws std::runtime_error if there is no study.
StudyResults study_so_far(const std::filesystem::path& folder);

/// Writes study.csv, study.xlsx, study.h5, summary.json and report.html from the records in the folder, and returns the
/// results. Throws std::runtime_error if there is no study, or FileError.
StudyResults gather_study(const std::filesystem::path& folder);

}  // namespace overbend
