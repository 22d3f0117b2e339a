#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <stdexcept>

#include "app/check_lines.h"
#include "app/commands.h"
#include "app/fatigue_lines.h"
#include "app/finding_lines.h"
#include "app/follow_study.h"
#include "app/free_lines.h"
#include "app/mooring_lines.h"
#include "app/seeds_lines.h"
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

void range(const std::string& name, const Spread& spread, const char* si, int digits = 2) {
  if (std::isnan(spread.min)) {
    std::cout << fmt::format("  {:<28}{:>12}\n", name, "none");
    return;
  }
  std::cout << fmt::format("  {:<28}{:>12} to {}\n", name, shown_number(spread.min, si, digits),
                           shown(spread.max, si, digits));
}

void print_pipe(const StaticResults& statics, const DynamicResults& r) {
  range("top tension", r.top_tension, "N");
  if (statics.overbend) number("overbend von Mises, largest", r.overbend.von_mises.over_time.max, "Pa");
  if (statics.tower) number("tower von Mises, largest", r.tower.von_mises.over_time.max, "Pa");
  number("sagbend von Mises, largest", r.sagbend.von_mises.over_time.max, "Pa");
  number("smallest tension of all", r.smallest_tension.over_time.min, "N");
  if (statics.stinger_tip_clearance) range("stinger tip clearance", r.stinger_tip_clearance, "m", 3);
  if (!r.supports.empty()) {
    std::cout << fmt::format("  {:<28}{:>12}", "impacts", r.impact_count);
    std::cout << (r.hardest_impacts.empty()
                      ? std::string("\n")
                      : ", the hardest " + shown(r.hardest_impacts.front().peak_force, "N", 1) + "\n");
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
  std::cout << verdict_line(r.checks, findings) << finding_lines(findings);
}

/// Where there is nothing left to run: says so and shows what it gave.
int tell_finished(const fs::path& folder, bool strict) {
  const StoredDynamics stored = read_dynamic_results(folder / "results.h5");
  std::cerr << fmt::format("The run in {} is finished after {:.6g} s. Without --resume it is run again.\n",
                           folder.string(), stored.results.duration);
  print_results(stored.statics.results, stored.results);
  std::cout << "Results are in " << folder.string() << "\n";
  return strict_code(stored.results.checks, all_findings(stored.statics.results, stored.results), strict);
}

/// One run straight into the folder.
int tell_single(const StudyEnd& end, const fs::path& folder, bool strict) {
  if (end.ending != RunEnding::done) return tell(end);
  if (!end.single.end.results) return tell_finished(folder, strict);
  print_results(end.statics, *end.single.end.results);
  std::cout << "Results are in " << folder.string() << "\n";
  const DynamicResults& results = *end.single.end.results;
  return strict_code(results.checks, all_findings(end.statics, results), strict);
}

StudyPlan plan_of(const Description& description, const DynamicArguments& arguments) {
  const std::optional<double> duration = duration_of(arguments.duration);
  if (!description.dynamics || description.dynamics->seeds.size() < 2) return plan_single(duration);
  std::variant<StudyPlan, std::string> plan = plan_seeds(description.dynamics->seeds, duration);
  if (const auto* fault = std::get_if<std::string>(&plan)) throw std::invalid_argument(*fault);
  return std::get<StudyPlan>(plan);
}

/// The stage that is asked for; of a run that is resumed, the one that it was begun with.
std::string wanted_stage(const DynamicArguments& arguments, const std::vector<fs::path>& folders) {
  if (!arguments.stage.empty() || !arguments.take_up.resume) return arguments.stage;
  for (const fs::path& folder : folders) {
    if (const std::optional<RunRecord> record = read_record(folder)) return record->stage;
  }
  return "";
}

/// Puts the stage of the operation on the line in place of the lay as such; says where none was chosen.
std::optional<RunEnd> take_stage(const std::string& wanted, Description& description) {
  if (wanted.empty()) {
    if (!is_lay_operation(description.operation.type)) return std::nullopt;
    description.findings.push_back(no_stage_finding(description));
    std::cout << finding_lines({description.findings.back()});
    return std::nullopt;
  }
  std::variant<Description, RunEnd> chosen = choose_stage(description, wanted);
  if (const RunEnd* fault = std::get_if<RunEnd>(&chosen)) return *fault;
  description = std::get<Description>(std::move(chosen));
  return std::nullopt;
}

int run_plan(const Description& description, const StudyPlan& plan, const fs::path& folder,
             const DynamicArguments& arguments) {
  const std::optional<bool> resume = goes_on(case_folders(plan, folder), arguments.take_up);
  if (!resume) return kWrongInput;
  const CaseOptions options{*resume, arguments.checkpoint_every, arguments.threads};
  const StudyEnd end = follow_study(description, plan, folder, options, "seeds");
  return plan.kind == StudyKind::single ? tell_single(end, folder, arguments.strict)
                                        : tell_seeds(end, folder, arguments.strict);
}

}  // namespace

int run_dynamic(const DynamicArguments& arguments) {
  std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".results")
                              : fs::path(arguments.output);
  if (const std::optional<RunEnd> lost = files_in_the_way(arguments.model_file, folder)) return tell(*lost);
  StudyPlan plan;
  try {
    plan = plan_of(*description, arguments);
    const std::string stage = wanted_stage(arguments, case_folders(plan, folder));
    if (const std::optional<RunEnd> fault = take_stage(stage, *description)) return tell(*fault);
  } catch (const std::invalid_argument& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
  std::cout << finding_lines(serious_findings(model_findings(build_model(*description)))) << std::flush;
  return run_plan(*description, plan, folder, arguments);
}

}  // namespace overbend
