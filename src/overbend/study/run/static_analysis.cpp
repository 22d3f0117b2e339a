#include "study/run/static_analysis.h"

#include <stdexcept>

#include "base/version.h"
#include "checks/run_checks.h"
#include "report/report.h"
#include "resultfiles/static/results_writer.h"
#include "results/findings.h"
#include "runstore/staged_folder.h"
#include "statics/moored/hull_statics.h"
#include "statics/recovery/current_effect.h"
#include "statics/recovery/history_effect.h"
#include "statics/recovery/recovery_parts.h"
#include "statics/recovery/roller_friction_limits.h"
#include "statics/recovery/side_rollers.h"

namespace overbend {

StaticResults recover_without_checks(const Model& model, const ModelEquilibrium& equilibrium) {
  StaticResults results;
  if (equilibrium.solution->has_pipe()) results = recover_in_current(model, *equilibrium.solution);
  results.title = model.description.title;
  results.version = kVersion;
  results.findings = merge(std::move(results.findings), equilibrium.findings);
  results.assumptions = merge(std::move(results.assumptions), equilibrium.assumptions);
  if (std::optional<Finding> finding = warn_of_side_roller_contact(model.description, results)) {
    results.findings.push_back(std::move(*finding));
  }
  results.moorings = equilibrium.moorings;
  if (!equilibrium.solution->has_pipe()) results.lines = equilibrium.lines;
  results.bodies = equilibrium.bodies;
  results.lift = equilibrium.lift;
  return results;
}

void add_code_checks(const Model& model, const StaticSolution& solution, StaticResults& results,
                     std::optional<StaticSolution>& still_water) {
  if (solution.has_pipe()) find_current_effect(model, solution, results, still_water);
  fill_checks(model, results);
  accept(results.findings, model.description.checks.accepted_findings);
}

StaticResults checked_statics(const Model& model, const ModelEquilibrium& equilibrium) {
  StaticResults results = recover_without_checks(model, equilibrium);
  std::optional<StaticSolution> still_water;
  add_code_checks(model, *equilibrium.solution, results, still_water);
  return results;
}

StaticRun run_statics(Model& model, const StaticSolution* start) {
  StaticRun run;
  ModelEquilibrium equilibrium = solve_equilibrium(model, start);
  run.failure = std::move(equilibrium.failure);
  if (run.failure) return run;
  run.results = checked_statics(model, equilibrium);
  run.solution = std::move(equilibrium.solution);
  return run;
}

void add_roller_friction_limits(Model model, const StaticSolution& solution, StaticResults& results) {
  if (!solution.has_pipe()) return;
  model.mean_pose = solution.pose;
  find_roller_friction_limits(model, solution, results);
  note_history_effect(model, solution, results);
  accept(results.findings, model.description.checks.accepted_findings);
}

void add_hull_results(const Model& model, StaticResults& results) {
  try {
    if (std::optional<HullStatics> account =
            compute_hull_statics(model, results.moorings ? &results.moorings->rest : nullptr)) {
      results.findings = merge(std::move(results.findings), account->findings);
      results.assumptions = merge(std::move(results.assumptions), account->assumptions);
      results.hull = std::move(account->results);
    }
  } catch (const std::invalid_argument& error) {  // statics are valid without it; a dynamic run will be rejected
    results.findings.push_back({FindingCode::hull_not_evaluated,
                                std::string("radiation and damping of the hull are not evaluated: ") + error.what()});
  }
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
