/// Runs the cases of a study side by side into its folder.
#pragma once

#include <filesystem>
#include <optional>

#include "study/campaign/study_folder.h"

namespace overbend {

struct TrialTold;

struct StudyRunOptions {
  int threads = 0;            ///< 0: as many as there are cores.
  bool retry_failed = false;  ///< Cases that failed before are run again.
  std::size_t task = 0,
              tasks = 1;           ///< Only the cases whose number leaves the remainder `task` when divided by `tasks`.
  double checkpoint_every = 60.0;  ///< Of dynamic analyses [s].
  bool tables = true;              ///< Made when all cases are run; several tasks leave them to who gathers.
};

/// Whoever follows a study. Called from several threads, but for begin().
class StudyWatch {
 public:
  StudyWatch() = default;
  virtual ~StudyWatch() = default;
  StudyWatch(const StudyWatch&) = delete;
  StudyWatch& operator=(const StudyWatch&) = delete;

  /// Whether to end, dynamic analyses at a checkpoint.
  virtual bool stop() = 0;
  /// Once, before the first case: those to be run, and those that were finished before.
  virtual void begin(std::size_t open, std::size_t finished);
  virtual void ended(const StudyCase& one);
  /// Of a search for limits, in place of ended(): an analysis that has just been made.
  virtual void tried(const TrialTold& trial);
};

/// What became of the cases.
struct StudyTally {
  std::size_t done = 0, failed = 0;  ///< Of this sitting.
  std::size_t before = 0;            ///< Finished when it began.
  std::size_t elsewhere = 0;         ///< At work in other processes.
  bool interrupted = false;
};

/// Runs what has no record yet. What the cases give does not depend on the number of threads or processes, nor on
/// interruptions. Several processes may share the folder: no case is run by two of them. A case that fails does not
/// stop the others. Throws FileFault where the disk refuses a record.
StudyTally run_study_cases(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder,
                           const StudyRunOptions& options, StudyWatch& watch);

/// Runs one case by itself, whatever its record says, with all result files in its folder, and records it. Where it
/// fails although its record has a result, which another case may have led to, the record stays and the reason says so.
StudyCase run_study_case(const CaseBase& base, const StudyCases& cases, const std::filesystem::path& folder,
                         std::size_t number, const std::function<bool()>& stop);

/// All that the records in the folder say, with extremes over seeds. Throws std::runtime_error where there is no study.
StudyResults study_so_far(const std::filesystem::path& folder);

/// Makes study.csv, study.xlsx, study.h5, summary.json and report.html from the records in the folder, and gives what
/// they say. Throws std::runtime_error where there is no study, or FileFault.
StudyResults gather_study(const std::filesystem::path& folder);

}  // namespace overbend
