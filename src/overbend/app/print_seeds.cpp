#include "app/print_seeds.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "app/print_checks.h"
#include "app/print_findings.h"
#include "base/finding.h"
#include "resultfiles/studies/seeds_writer.h"

namespace overbend {
namespace {

void print(const SeedsResults& results) {
  std::cout << fmt::format("  {:<28}{:>12}{:>12}{:>12}{:>12}\n", "over the seeds", "mean", "std", "min", "max");
  for (std::size_t i = 0; i < results.statistics.size(); ++i) {
    const SeedQuantity& quantity = results.quantities[i];
    const SeedStatistics& s = results.statistics[i];
    if (std::isnan(s.mean)) continue;  // missing in every run
    const ShownUnit unit = table_unit(quantity);
    std::cout << fmt::format("  {:<28}{:>12.4g}{:>12.3g}{:>12.4g}{:>12.4g} {}\n", quantity.name, s.mean * unit.factor,
                             s.std * unit.factor, s.min * unit.factor, s.max * unit.factor, unit.name);
  }
  std::vector<Findings> findings;
  for (const SeedRun& run : results.runs) findings.push_back(run.findings);
  std::cout << shared_finding_lines(findings, "seeds");
  std::cout << finding_lines(results.findings);
}

/// Returns the findings of all seeds and of the study.
Findings all_findings(const SeedsResults& results) {
  Findings all = results.findings;
  for (const SeedRun& run : results.runs) all = merge(std::move(all), run.findings);
  return all;
}

}  // namespace

ExitCode report_seeds(const StudyOutcome& end, const std::filesystem::path& folder, bool strict) {
  if (!end.seeds) return report_status(end);
  for (const FailedSeed& failed : end.seeds->failed) {
    std::cerr << "overbend: seed " << failed.seed << ": " << failed.why << "\n";
  }
  if (!end.seeds->runs.empty()) {
    std::cout << fmt::format("{}\n  {:<28}{:>12} of {}\n", end.statics.title, "seeds done", end.seeds->runs.size(),
                             end.seeds->runs.size() + end.seeds->failed.size());
    print(*end.seeds);
    std::cout << "Results are in " << folder.string() << "\n";
  }
  return end.ending == RunStatus::done ? strict_code(end.worst, all_findings(*end.seeds), strict) : report_status(end);
}

}  // namespace overbend
