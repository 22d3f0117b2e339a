#include "results/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/ranges.h"

namespace overbend {
namespace {

Findings stage_findings(const StageResult& stage) {
  return stage.lay ? merge(stage.findings, stage.lay->findings) : stage.findings;
}

Finding with_stages(const SharedFinding& shared, std::size_t stages) {
  Finding finding = shared.worst;
  finding.message = shared.text();
  if (shared.runs.size() == stages) return finding;
  std::vector<std::size_t> numbers = shared.runs;
  for (std::size_t& number : numbers) ++number;
  finding.message += fmt::format(" (stage{} {})", numbers.size() == 1 ? "" : "s", fmt::join(numbers, ", "));
  return finding;
}

}  // namespace

Findings all_findings(const StaticResults& statics, const DynamicResults& results) {
  return merge(results.findings, statics.findings);
}

Findings operation_findings(const OperationResults& results) {
  Findings all;
  std::vector<Findings> stages;
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const StageResult& stage = results.stages[i];
    stages.push_back(stage_findings(stage));
    if (!stage.failure) continue;
    all.push_back(
        Finding{FindingCode::stage_without_equilibrium,
                fmt::format("stage {} ({}) has no equilibrium: {}", i + 1, stage.stage.name, stage.failure->why)}
            .on("stage " + std::to_string(i + 1)));
  }
  append(all, results.findings);
  for (const SharedFinding& shared : shared_findings(stages)) all.push_back(with_stages(shared, stages.size()));
  return all;
}

Verdict stage_verdict(const StageResult& stage) {
  if (stage.lay) return make_verdict(stage.lay->checks, stage_findings(stage));
  return {VerdictKind::exceeded, "NO EQUILIBRIUM", stage.failure ? stage.failure->why : ""};
}

CheckTable operation_checks(const OperationResults& results) {
  CheckTable all;
  for (const StageResult& stage : results.stages) {
    if (!stage.lay) continue;
    all.rows.insert(all.rows.end(), stage.lay->checks.rows.begin(), stage.lay->checks.rows.end());
  }
  return all;
}

Verdict operation_verdict(const OperationResults& results) {
  Verdict verdict = make_verdict(operation_checks(results), operation_findings(results));
  const auto failed = ranges::count_if(results.stages, [](const StageResult& stage) { return !stage.lay; });
  if (failed == 0) return verdict;
  const std::string text = fmt::format("{} OF {} STAGES WITHOUT EQUILIBRIUM", failed, results.stages.size());
  verdict.headline = verdict.kind == VerdictKind::exceeded ? text + ", " + verdict.headline : text;
  verdict.kind = VerdictKind::exceeded;
  return verdict;
}

}  // namespace overbend
