/// Text of a study for the terminal.
#pragma once

#include <chrono>
#include <mutex>
#include <optional>
#include <string>

#include "app/progress.h"
#include "study/campaign/study_probe.h"
#include "study/campaign/study_runner.h"
#include "study/operability/operability_plan.h"

namespace overbend {

/// Returns the title and the number of cases or of limits to search, printed before the study starts.
std::string study_head(const CaseBase& base, const StudyCases& cases);

/// Returns the cases with their inputs; only the first and last if there are many.
std::string case_list(const StudyCases& cases, const CaseBase& base);

/// Returns the run time of the study on `cores` cores, estimated from a probe.
std::string probe_lines(const StudyProbe& probe, std::size_t cases, std::size_t cores);

/// The same for a search for limits: a bisection of the values in every cell, with all seeds at its end.
std::string search_probe_lines(const StudyProbe& probe, const OperabilityPlan& plan, std::size_t cores);

/// Returns a case with its results.
std::string case_lines(const StudyCase& study_case, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs);

/// Returns the number of cases that pass, the range of every result, and the failed cases with the commands that run
/// them.
std::string study_lines(const StudyResults& results, const std::string& study_file, const std::string& folder);

/// Returns the number of cases run by this process.
std::string tally_line(const StudyTally& tally);

/// Progress on stderr, and Ctrl-C.
class CaseProgressPrinter : public StudyObserver {
 public:
  explicit CaseProgressPrinter(const StudyDescription& study);
  bool stop() override;
  void begin(std::size_t open, std::size_t finished) override;
  void ended(const StudyCase& study_case) override;
  void tried(const TrialReport& trial) override;

 private:
  std::optional<OperabilityPlan> plan_;  ///< Plan of a search for limits.
  std::mutex mutex_;                     ///< Guards the members below.
  std::size_t open_ = 0, done_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point begun_{};
  std::optional<Progress> progress_;
};

}  // namespace overbend
