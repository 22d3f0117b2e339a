/// A study on the terminal.
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

/// Title, and the number of cases, or of limits that are searched: printed before anything runs.
std::string study_head(const CaseBase& base, const StudyCases& cases);

/// The cases with their inputs, first and last where there are many.
std::string case_list(const StudyCases& cases, const CaseBase& base);

/// What a probe says of the time that the whole study takes on so many cores.
std::string probe_lines(const StudyProbe& probe, std::size_t cases, std::size_t cores);

/// The same of a search for limits: a bisection of the values in every cell, and all seeds at its end.
std::string search_probe_lines(const StudyProbe& probe, const OperabilityPlan& plan, std::size_t cores);

/// One case with its results.
std::string case_lines(const StudyCase& one, const std::vector<StudyInput>& inputs,
                       const std::vector<StudyOutput>& outputs);

/// How many pass, the range of every result, and cases that failed with the commands that run them alone.
std::string study_lines(const StudyResults& results, const std::string& study_file, const std::string& folder);

/// What this sitting did.
std::string tally_line(const StudyTally& tally);

/// Progress on stderr, and Ctrl-C.
class FollowedCases : public StudyWatch {
 public:
  explicit FollowedCases(const StudyDescription& study);
  bool stop() override;
  void begin(std::size_t open, std::size_t finished) override;
  void ended(const StudyCase& one) override;
  void tried(const TrialTold& trial) override;

 private:
  std::optional<OperabilityPlan> plan_;  ///< Of a search for limits.
  std::mutex mutex_;                     ///< Of what follows.
  std::size_t open_ = 0, done_ = 0, failed_ = 0;
  std::chrono::steady_clock::time_point begun_{};
  std::optional<Progress> progress_;
};

}  // namespace overbend
