#include "report/operation_verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "report/hold_points.h"
#include "report/html.h"
#include "report/places.h"
#include "report/sections.h"
#include "report/stage_columns.h"
#include "report/stage_words.h"
#include "report/stages_section.h"

namespace overbend {
namespace {

using html::fixed;

/// The checks of all stages in one table, whose verdict is that of all.
CheckTable all_checks(const OperationResults& results) {
  CheckTable all;
  for (const StageResult& stage : results.stages) {
    if (!stage.lay) continue;
    all.rows.insert(all.rows.end(), stage.lay->checks.rows.begin(), stage.lay->checks.rows.end());
  }
  return all;
}

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

/// Warnings that several stages have, told once: text with the numbers of the stages.
struct Told {
  std::string text;
  std::vector<std::string> stages;
};

void tell(std::vector<Told>& all, const std::string& text, const std::string& stage) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Told& one) { return one.text == text; });
  Told& told = at == all.end() ? all.emplace_back(Told{text, {}}) : *at;
  if (std::find(told.stages.begin(), told.stages.end(), stage) == told.stages.end()) told.stages.push_back(stage);
}

std::string with_stages(const WeighedWarning& warning, const std::vector<Told>& all,
                        const std::vector<std::string>& weighed_as, std::size_t of) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (weighed_as[i] != warning.text) continue;
    const std::vector<std::string>& stages = all[i].stages;
    if (stages.empty() || stages.size() == of) return warning.text;
    return fmt::format("{} (stage{} {})", warning.text, stages.size() == 1 ? "" : "s", fmt::join(stages, ", "));
  }
  return warning.text;
}

}  // namespace

Verdict operation_verdict(const OperationResults& results, const std::vector<WeighedWarning>& warnings) {
  const auto failed = static_cast<std::size_t>(std::count_if(
      results.stages.begin(), results.stages.end(), [](const StageResult& stage) { return !stage.lay.has_value(); }));
  const CheckTable checks = all_checks(results);
  Verdict verdict = with_stage(verdict_of(checks, warnings), checks, results);
  if (failed == 0) {
    verdict.because = "All " + stages_words(results.stages.size()) + " have an equilibrium. " + verdict.because;
    return verdict;
  }
  const std::string words = fmt::format("{} OF {} STAGES CANNOT BE", failed, results.stages.size());
  verdict.words = verdict.kind == VerdictKind::exceeded ? words + "; " + verdict.words : words;
  verdict.kind = VerdictKind::exceeded;
  return verdict;
}

std::vector<UtilisationBar> operation_bars(const OperationResults& results) {
  std::vector<UtilisationBar> bars;
  for (const CheckRegion region : check_regions()) {
    std::optional<UtilisationBar> most;
    for (const std::size_t i : all_stages(results)) {
      const std::optional<StaticResults>& lay = results.stages[i].lay;
      const CheckRow* row = lay ? governing_check(lay->checks, region) : nullptr;
      if (row == nullptr || (most && row->utilisation <= most->utilisation)) continue;
      most = UtilisationBar{
          region_title(region), row->utilisation,
          fmt::format("{}, {}; {}; stage {}", row->name, row->code, place_name(*lay, row->s), stage_title(results, i))};
    }
    if (most) bars.push_back(*most);
  }
  std::optional<UtilisationBar> cable;
  for (const std::size_t i : all_stages(results)) {
    const std::optional<StaticResults>& lay = results.stages[i].lay;
    if (!lay || !lay->cable || !lay->cable->utilisation) continue;
    const double use = *lay->cable->utilisation;
    if (cable && use <= cable->utilisation) continue;
    cable = UtilisationBar{"Cable", use,
                           fmt::format("Largest tension over breaking load; stage {}", stage_title(results, i))};
  }
  if (cable) bars.push_back(*cable);
  return bars;
}

std::vector<WeighedWarning> operation_warnings(const OperationResults& results) {
  std::vector<WeighedWarning> all;
  std::vector<Told> told;
  for (const std::string& warning : results.warnings) told.push_back({warning, {}});
  for (const std::size_t i : all_stages(results)) {
    const StageResult& stage = results.stages[i];
    const std::string number = std::to_string(i + 1);
    if (stage.failure) all.push_back({WarningWeight::serious, failure_words(results, i)});
    for (const std::string& warning : stage.warnings) tell(told, warning, number);
    if (!stage.lay) continue;
    for (const std::string& warning : stage.lay->warnings) tell(told, warning, number);
  }
  std::vector<std::string> texts, weighed_as;
  for (const Told& one : told) {
    texts.push_back(one.text);
    weighed_as.push_back(weighed({one.text}).front().text);
  }
  for (WeighedWarning warning : weighed(texts)) {
    warning.text = with_stages(warning, told, weighed_as, results.stages.size());
    all.push_back(warning);
  }
  return all;
}

}  // namespace overbend
