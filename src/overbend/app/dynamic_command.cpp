#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/print_checks.h"
#include "app/print_fatigue.h"
#include "app/print_findings.h"
#include "app/print_lines_and_bodies.h"
#include "app/print_moorings.h"
#include "app/print_seeds.h"
#include "app/study_progress.h"
#include "base/finding.h"
#include "base/shown_unit.h"
#include "model/model.h"
#include "model/model_findings.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "results/findings.h"
#include "study/run/run_folder.h"
#include "study/stages/stage_choice.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

void number(const std::string& name, double value, const char* si, int digits = 2) {
  std::cout << fmt::format("  {:<28}{:>12} {}\n", name, shown_number(value, si, digits), shown_name(si));
}

void range(const std::string& name, const SummaryStatistics& spread, const char* si, int digits = 2) {
  if (std::isnan(spread.min)) {
    std::cout << fmt::format("  {:<28}{:>12}\n", name, "none");
    return;
  }
  std::cout << fmt::format("  {:<28}{:>12} to {}\n", name, shown_number(spread.min, si, digits),
                           shown(spread.max, si, digits));
}

void print_pipe(const StaticResults& statics, const DynamicResults& r) {
  range("top tension", r.top_tension, "N");
  if (statics.overbend) number("max. overbend von Mises", r.overbend.von_mises.over_time.max, "Pa");
  if (statics.tower) number("max. tower von Mises", r.tower.von_mises.over_time.max, "Pa");
  number("max. sagbend von Mises", r.sagbend.von_mises.over_time.max, "Pa");
  number("minimum tension", r.min_effective_tension.over_time.min, "N");
  if (statics.stinger_tip_clearance) range("stinger tip clearance", r.stinger_tip_clearance, "m", 3);
  if (!r.supports.empty()) {
    std::cout << fmt::format("  {:<28}{:>12}", "impacts", r.impact_count);
    std::cout << (r.hardest_impacts.empty()
                      ? std::string("\n")
                      : ", maximum force " + shown(r.hardest_impacts.front().peak_force, "N", 1) + "\n");
  }
}

void print_results(const StaticResults& statics, const DynamicResults& r) {
  std::cout << statics.title << "\n";
  if (statics.has_pipe()) print_pipe(statics, r);
  std::cout << moored_dynamics_lines(r);
  std::cout << lines_in_time(statics.lines, r.lines) << bodies_in_time(r.bodies);
  if (statics.hull) std::cout << hull_lines(*statics.hull);
  std::cout << fatigue_lines(r) << check_lines(r.checks);
  std::cout << fmt::format("  {:<28}{:>12.1e} of the energy exchanged\n", "energy drift", r.energy.drift());
  std::cout << fmt::format("  {:<28}{:>12.2f} s, {} steps, {:.0f} times real time\n", "time loop", r.run.wall_time,
                           r.run.steps, r.run.real_time_ratio);
  const Findings findings = all_findings(statics, r);
  std::cout << verdict_line(make_verdict(r.checks, findings)) << finding_lines(findings);
}

/// Reports a run that is already finished, and prints its results.
int report_finished(const fs::path& folder, bool strict) {
  const StoredDynamics stored = read_dynamic_results(folder / "results.h5");
  std::cerr << fmt::format("The run in {} is already finished ({:.6g} s). Omit --resume to run it again.\n",
                           folder.string(), stored.results.duration);
  print_results(stored.statics.results, stored.results);
  std::cout << "Results are in " << folder.string() << "\n";
  return strict_code(stored.results.checks, all_findings(stored.statics.results, stored.results), strict);
}

/// Reports a single run in `folder`.
int report_single_run(const StudyOutcome& end, const fs::path& folder, bool strict) {
  if (end.ending != RunStatus::done) return report_status(end);
  if (!end.single.end.results) return report_finished(folder, strict);
  print_results(end.statics, *end.single.end.results);
  std::cout << "Results are in " << folder.string() << "\n";
  const DynamicResults& results = *end.single.end.results;
  return strict_code(results.checks, all_findings(end.statics, results), strict);
}

StudyPlan make_plan(const Description& description, const DynamicArguments& arguments) {
  const std::optional<double> duration = parse_duration_option(arguments.duration);
  if (!description.dynamics || description.dynamics->seeds.size() < 2) return plan_single(duration);
  std::variant<StudyPlan, std::string> plan = plan_seeds(description.dynamics->seeds, duration);
  if (const auto* error = std::get_if<std::string>(&plan)) throw std::invalid_argument(*error);
  return std::get<StudyPlan>(plan);
}

/// Returns the requested stage; for a resumed run, the stage it was started with.
std::string requested_stage(const DynamicArguments& arguments, const std::vector<fs::path>& folders) {
  if (!arguments.stage.empty() || !arguments.resume_option.resume) return arguments.stage;
  for (const fs::path& folder : folders) {
    if (const std::optional<RunRecord> record = read_record(folder)) return record->stage;
  }
  return "";
}

/// Replaces the normal lay by the requested stage of the operation; reports if no stage was chosen.
std::optional<RunResult> apply_stage(const std::string& wanted, Description& description) {
  if (wanted.empty()) {
    if (!is_lay_operation(description.operation.type)) return std::nullopt;
    description.findings.push_back(no_stage_finding(description));
    std::cout << finding_lines({description.findings.back()});
    return std::nullopt;
  }
  std::variant<Description, RunResult> chosen = choose_stage(description, wanted);
  if (const RunResult* error = std::get_if<RunResult>(&chosen)) return *error;
  description = std::get<Description>(std::move(chosen));
  return std::nullopt;
}

int run_plan(const Description& description, const StudyPlan& plan, const fs::path& folder,
             const DynamicArguments& arguments) {
  const std::optional<bool> resume = resume_requested(case_folders(plan, folder), arguments.resume_option);
  if (!resume) return kWrongInput;
  const CaseOptions options{*resume, arguments.checkpoint_every, arguments.threads};
  const StudyOutcome end = follow_study(description, plan, folder, options, "seeds");
  return plan.kind == StudyKind::single ? report_single_run(end, folder, arguments.strict)
                                        : report_seeds(end, folder, arguments.strict);
}

}  // namespace

int run_dynamic(const DynamicArguments& arguments) {
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".results")
                              : fs::path(arguments.output);
  if (const std::optional<RunResult> lost = find_output_conflict(arguments.model_file, folder)) {
    return report_status(*lost);
  }
  StudyPlan plan;
  try {
    plan = make_plan(*description, arguments);
    const std::string stage = requested_stage(arguments, case_folders(plan, folder));
    if (const std::optional<RunResult> error = apply_stage(stage, *description)) return report_status(*error);
  } catch (const std::invalid_argument& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
  std::cout << finding_lines(serious_findings(model_findings(build_model(*description)))) << std::flush;
  return run_plan(*description, plan, folder, arguments);
}

}  // namespace overbend
