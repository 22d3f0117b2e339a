#include "report/stages/operation_verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "report/stages/hold_points.h"
#include "report/stages/stage_columns.h"
#include "report/stages/stage_labels.h"
#include "report/stages/stages_section.h"
#include "results/fields/location_names.h"
#include "results/findings.h"

namespace overbend {
namespace {

std::string stage_count_text(std::size_t count) {
  return fmt::format("{} stage{}", count, count == 1 ? "" : "s");
}

Verdict with_stage(Verdict verdict, const CheckTable& checks, const OperationResults& results) {
  const std::optional<std::size_t> hardest = find_governing_stage_index(results);
  if (!hardest) return verdict;
  const StageUtilisation use = *find_max_utilisation(results.stages[*hardest]);
  const std::string stage = "stage " + stage_title(results, *hardest);
  if (use.utilisation > 1.0) {
    verdict.kind = VerdictKind::exceeded;
    verdict.headline =
        fmt::format("EXCEEDED {}, {}, {}", fixed(use.utilisation, use.utilisation < 1.005 ? 4 : 2), use.what, stage);
  }
  const CheckRow* worst = find_governing_check(checks);
  const bool is_check = worst != nullptr && worst->utilisation >= use.utilisation;
  verdict.because += is_check ? fmt::format(" It occurs at {}.", stage)
                              : fmt::format(" The maximum utilisation is that of the {}, at {}: {}.", use.what, stage,
                                            fixed(use.utilisation, 3));
  return verdict;
}

}  // namespace

Verdict verdict_with_stage(const OperationResults& results) {
  Verdict verdict = operation_verdict(results);
  const bool all = ranges::all_of(results.stages, [](const StageResult& stage) { return stage.lay.has_value(); });
  if (!all) return verdict;
  verdict = with_stage(std::move(verdict), operation_checks(results), results);
  verdict.because = "All " + stage_count_text(results.stages.size()) + " have an equilibrium. " + verdict.because;
  return verdict;
}

std::vector<Utilisation> operation_bars(const OperationResults& results) {
  std::vector<Utilisation> bars;
  for (const CheckRegion region : check_regions()) {
    std::optional<Utilisation> max_utilisation;
    for (const std::size_t i : all_stages(results)) {
      const std::optional<StaticResults>& lay = results.stages[i].lay;
      const CheckRow* row = lay ? governing_check(lay->checks, region) : nullptr;
      if (row == nullptr || (max_utilisation && row->utilisation <= max_utilisation->utilisation)) continue;
      max_utilisation = Utilisation{region_title(region), row->utilisation,
                                    fmt::format("{}, {}; {}; stage {}", row->name, row->code, location_name(*lay, *row),
                                                stage_title(results, i))};
    }
    if (max_utilisation) bars.push_back(*max_utilisation);
  }
  return bars;
}

}  // namespace overbend
