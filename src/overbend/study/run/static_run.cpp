#include "study/run/static_run.h"

#include <stdexcept>

#include "checks/run_checks.h"
#include "report/report.h"
#include "resultfiles/static/results_writer.h"
#include "results/findings.h"
#include "runstore/staged_folder.h"
#include "statics/moored/hull_account.h"
#include "statics/recovery/current_effect.h"
#include "statics/recovery/friction_cases.h"
#include "statics/recovery/history_effect.h"
#include "statics/recovery/recovery_parts.h"
#include "statics/recovery/side_rollers.h"

namespace overbend {

StaticResults unjudged_statics(const Model& model, const LayOutcome& lay) {
  StaticResults results = recover_in_current(model, *lay.solution);
  if (lay.moorings) {
    results.findings = merge(std::move(results.findings), lay.moorings->findings);
    results.assumptions = merge(std::move(results.assumptions), lay.moorings->assumptions);
    if (std::optional<Finding> finding = find_side_roller_contact(model.description, results)) {
      results.findings.push_back(std::move(*finding));
    }
    results.moorings = lay.moorings;
  }
  return results;
}

void judge_statics(const Model& model, const StaticSolution& solution, StaticResults& results,
                   std::optional<StaticSolution>& still) {
  find_current_effect(model, solution, results, still);
  fill_checks(model, results);
  accept(results.findings, model.description.checks.accepted_findings);
}

StaticResults checked_statics(const Model& model, const LayOutcome& lay) {
  StaticResults results = unjudged_statics(model, lay);
  std::optional<StaticSolution> still;
  judge_statics(model, *lay.solution, results, still);
  return results;
}

void tell_friction(Model model, const LayOutcome& lay, StaticResults& results) {
  model.mean_pose = lay.solution->pose;
  find_friction_cases(model, *lay.solution, results);
  note_history_effect(model, *lay.solution, results);
  accept(results.findings, model.description.checks.accepted_findings);
}

namespace {

/// Its results, where the hull has any; what it warns of and assumes goes to `into`.
template <class Results>
std::optional<HullResults> told_hull(const Model& model, const MooredState* rest, Results& into) {
  try {
    std::optional<HullAccount> account = hull_account(model, rest);
    if (!account) return std::nullopt;
    into.findings = merge(std::move(into.findings), account->findings);
    into.assumptions = merge(std::move(into.assumptions), account->assumptions);
    return std::move(account->results);
  } catch (const std::invalid_argument& fault) {  // statics stand without it; a run in time will be refused
    into.findings.push_back({FindingCode::hull_not_evaluated,
                             std::string("radiation and damping of the hull are not evaluated: ") + fault.what()});
    return std::nullopt;
  }
}

}  // namespace

void tell_hull(const Model& model, StaticResults& results) {
  results.hull = told_hull(model, results.moorings ? &results.moorings->rest : nullptr, results);
  accept(results.findings, model.description.checks.accepted_findings);
}

void tell_hull(const Model& model, MooringResults& results) {
  fill_checks(model, results);
  results.hull = told_hull(model, &results.rest, results);
  accept(results.findings, model.description.checks.accepted_findings);
}

void write_static_run(const StaticResults& results, const Description& description, const std::filesystem::path& folder,
                      const SensitivityResults* sensitivities) {
  StagedFolder staged(folder);
  write_static_files(results, description, staged.path(), sensitivities);
  write_report(results, description.source_text, staged.path() / "report.html", {.sensitivities = sensitivities});
  staged.commit("summary.json");
}

}  // namespace overbend
