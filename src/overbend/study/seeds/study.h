/// A study: the cases of one model, run side by side, and what they say together.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/file_lock.h"
#include "results/comparison_results.h"
#include "results/seeds_results.h"
#include "study/run/case.h"
#include "study/run/run_cases.h"

namespace overbend {

enum class StudyKind { single, seeds, comparison };

/// What is run. A single run is a study of one case, in the study's own folder.
struct StudyPlan {
  StudyKind kind = StudyKind::single;
  ComparisonOf of = ComparisonOf::tensioner;  ///< Of a comparison.
  std::vector<Case> cases;
};

/// `duration` [s]: instead of the model's.
StudyPlan plan_single(std::optional<double> duration);
/// One case "seed-K" for each seed.
std::vector<Case> seed_cases(const std::vector<std::uint64_t>& seeds);
/// The same as a plan. A sentence where a seed is given twice, or none at all.
std::variant<StudyPlan, std::string> plan_seeds(const std::vector<std::uint64_t>& seeds,
                                                std::optional<double> duration);
/// The variants of the model. A sentence where it cannot be compared so.
std::variant<StudyPlan, std::string> plan_comparison(ComparisonOf of, const Description& base,
                                                     std::optional<double> duration);

/// Where each case's run and results are.
std::vector<std::filesystem::path> case_folders(const StudyPlan& plan, const std::filesystem::path& folder);

struct FailedCase {
  std::string name, why;
};

/// How a study ended, and what it gave: the files are written already.
struct StudyEnd : RunEnd {
  StaticResults statics{};  ///< Of the first case.
  CaseRun single{};         ///< Of a single run.
  std::vector<FailedCase> failed{};
  std::optional<SeedsResults> seeds{};
  CheckTable worst{};  ///< Over the seeds: of the run whose governing check is used most.
  std::optional<Comparison> comparison{};
};

/// Prepares the cases, runs them into folders of their own in `folder` and gathers there. A case that fails does not
/// stop the others; seeds are gathered without it and end with no_solution, a comparison is then not written.
/// wrong_input when none can be run for a reason that is the input's. What is given does not depend on the number of
/// threads.
StudyEnd run_study(const Description& base, const StudyPlan& plan, const std::filesystem::path& folder,
                   const CaseOptions& options, CaseWatch& watch, FileLock& files);

}  // namespace overbend
