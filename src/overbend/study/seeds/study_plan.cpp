// Plans of studies.
#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "study/seeds/compare_variants.h"
#include "study/seeds/study.h"

namespace overbend {
namespace {

std::optional<std::uint64_t> twice(std::vector<std::uint64_t> seeds) {
  ranges::sort(seeds);
  const auto found = ranges::adjacent_find(seeds);
  return found == seeds.end() ? std::nullopt : std::optional(*found);
}

}  // namespace

StudyPlan plan_single(std::optional<double> duration) {
  Case study_case;
  study_case.duration = duration;
  return {StudyKind::single, ComparisonType::tensioner, {study_case}};
}

std::vector<Case> seed_cases(const std::vector<std::uint64_t>& seeds) {
  std::vector<Case> cases;
  for (const std::uint64_t seed : seeds) {
    cases.push_back({fmt::format("seed-{}", seed), fmt::format("Seed {}", seed), {}, {}, seed});
  }
  return cases;
}

std::variant<StudyPlan, std::string> plan_seeds(const std::vector<std::uint64_t>& seeds,
                                                std::optional<double> duration) {
  if (seeds.empty()) return "analysis.dynamic.seeds: no seed is given, expected at least one";
  if (const auto found = twice(seeds)) return fmt::format("analysis.dynamic.seeds: {} is given twice", *found);
  StudyPlan plan{StudyKind::seeds, ComparisonType::tensioner, seed_cases(seeds)};
  for (Case& study_case : plan.cases) study_case.duration = duration;
  return plan;
}

std::variant<StudyPlan, std::string> plan_comparison(ComparisonType of, const Description& base,
                                                     std::optional<double> duration) {
  if (std::optional<std::string> unsupported = unsupported_comparison(of, base)) return std::move(*unsupported);
  StudyPlan plan{StudyKind::comparison, of, make_variants(of)};
  for (Case& study_case : plan.cases) study_case.duration = duration;
  return plan;
}

std::vector<std::filesystem::path> case_folders(const StudyPlan& plan, const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> folders;
  for (const Case& study_case : plan.cases) {
    folders.push_back(study_case.name.empty() ? folder : folder / study_case.name);
  }
  return folders;
}

}  // namespace overbend
