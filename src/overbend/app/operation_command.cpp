#include "app/operation_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/check_lines.h"
#include "app/finding_lines.h"
#include "app/stage_lines.h"
#include "results/findings.h"
#include "results/worst_stage.h"
#include "runstore/staged_folder.h"
#include "study/run/prepared_case.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

int standing(const OperationResults& results) {
  return static_cast<int>(std::count_if(results.stages.begin(), results.stages.end(),
                                        [](const StageResult& stage) { return stage.lay.has_value(); }));
}

void print_summary(const OperationResults& results) {
  const std::size_t all = results.stages.size();
  std::cout << fmt::format("  {} of {} {} found in {:.2f} s\n", standing(results), all,
                           all == 1 ? "equilibrium" : "equilibria", results.wall_time);
  const Findings findings = operation_findings(results);
  if (const StageResult* worst = worst_stage(results)) std::cout << verdict_line(worst->lay->checks, findings);
  std::cout << finding_lines(findings);
}

}  // namespace

int run_static_operation(const Description& description, const std::filesystem::path& folder, bool strict) {
  if (const auto obstacle = operation_obstacle(description)) return tell(failed_end(*obstacle, description));
  std::cout << description.title << "\n" << stage_heads(description.operation.type);
  const auto tell_stage = [](const StageResult& stage, std::size_t) {
    std::cout << stage_line(stage) << std::flush;
    return true;
  };
  const OperationResults results = solve_operation(description, tell_stage);
  try {
    write_operation_run(results, description, folder);
  } catch (const UnusableFolder& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
  print_summary(results);
  std::cout << "Results are in " << folder.string() << "\n";
  if (standing(results) == 0) return tell({RunEnding::no_solution, "no stage of the operation has an equilibrium"});
  const StageResult* worst = worst_stage(results);
  return worst != nullptr ? strict_code(worst->lay->checks, operation_findings(results), strict) : kDone;
}

}  // namespace overbend
