#include "report/stages/operation_verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/stages/hold_points.h"
#include "report/stages/stage_columns.h"
#include "report/stages/stage_words.h"
#include "report/stages/stages_section.h"
#include "results/fields/places.h"
#include "results/findings.h"

namespace overbend {
namespace {

std::string stages_words(std::size_t count) {
  return fmt::format("{} stage{}", count, count == 1 ? "" : "s");
}

Verdict with_stage(Verdict verdict, const CheckTable& checks, const OperationResults& results) {
  const std::optional<std::size_t> hardest = hardest_stage(results);
  if (!hardest) return verdict;
  const StageUse use = *largest_use(results.stages[*hardest]);
  const std::string at = "stage " + stage_title(results, *hardest);
  if (use.utilisation > 1.0) {
    verdict.kind = VerdictKind::exceeded;
    verdict.words =
        fmt::format("EXCEEDED {}, {}, {}", fixed(use.utilisation, use.utilisation < 1.005 ? 4 : 2), use.what, at);
  }
  const CheckRow* worst = worst_check(checks);
  const bool is_check = worst != nullptr && worst->utilisation >= use.utilisation;
  verdict.because += is_check
                         ? fmt::format(" It is that of {}.", at)
                         : fmt::format(" Used most is the {}, at {}: {}.", use.what, at, fixed(use.utilisation, 3));
  return verdict;
}

}  // namespace

Verdict verdict_with_stage(const OperationResults& results) {
  Verdict verdict = operation_verdict(results);
  const bool all = std::ranges::all_of(results.stages, [](const StageResult& stage) { return stage.lay.has_value(); });
  if (!all) return verdict;
  verdict = with_stage(std::move(verdict), operation_checks(results), results);
  verdict.because = "All " + stages_words(results.stages.size()) + " have an equilibrium. " + verdict.because;
  return verdict;
}

std::vector<Utilisation> operation_bars(const OperationResults& results) {
  std::vector<Utilisation> bars;
  for (const CheckRegion region : check_regions()) {
    std::optional<Utilisation> most;
    for (const std::size_t i : all_stages(results)) {
      const std::optional<StaticResults>& lay = results.stages[i].lay;
      const CheckRow* row = lay ? governing_check(lay->checks, region) : nullptr;
      if (row == nullptr || (most && row->utilisation <= most->utilisation)) continue;
      most = Utilisation{
          region_title(region), row->utilisation,
          fmt::format("{}, {}; {}; stage {}", row->name, row->code, place_name(*lay, *row), stage_title(results, i))};
    }
    if (most) bars.push_back(*most);
  }
  return bars;
}

}  // namespace overbend
