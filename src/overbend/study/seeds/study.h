/// A study: the cases of one model, run concurrently, and their combined results.
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

/// Cases to run. A single run is a study of one case, in the study's own folder.
struct StudyPlan {
  StudyKind kind = StudyKind::single;
  ComparisonType of = ComparisonType::tensioner;  ///< Kind of a comparison.
  std::vector<Case> cases;
};

/// `duration` [s] replaces that of the model.
StudyPlan plan_single(std::optional<double> duration);
/// Returns one case "seed-K" for each seed.
std::vector<Case> seed_cases(const std::vector<std::uint64_t>& seeds);
/// Returns the same as a plan. Error message if a seed is given twice, or none at all.
std::variant<StudyPlan, std::string> plan_seeds(const std::vector<std::uint64_t>& seeds,
                                                std::optional<double> duration);
/// Returns the variants of the model. Error message if the model does not support the comparison.
std::variant<StudyPlan, std::string> plan_comparison(ComparisonType of, const Description& base,
                                                     std::optional<double> duration);

/// Returns the folder of each case.
std::vector<std::filesystem::path> case_folders(const StudyPlan& plan, const std::filesystem::path& folder);

struct FailedCase {
  std::string name, why;
};

/// Status and results of a study; the files are written already.
struct StudyOutcome : RunResult {
  StaticResults statics{};  ///< Statics of the first case.
  CaseRun single{};         ///< The single run.
  std::vector<FailedCase> failed{};
  std::optional<SeedsResults> seeds{};
  CheckTable worst{};  ///< Checks of the seed with the highest governing utilisation.
  std::optional<Comparison> comparison{};
};

/// Prepares the cases, runs them in their own folders below `folder` and gathers the results there. A failed case does
/// not stop the others; seeds are gathered without it and end with no_solution, a comparison is then not written.
/// Returns wrong_input if no case can be run because of its input. The results do not depend on the number of threads.
StudyOutcome run_study(const Description& base, const StudyPlan& plan, const std::filesystem::path& folder,
                       const CaseOptions& options, CaseObserver& watch, FileLock& files);

}  // namespace overbend
