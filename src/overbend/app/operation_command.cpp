#include "app/operation_command.h"

#include <fmt/format.h>

#include <iostream>

#include "app/print_checks.h"
#include "app/print_findings.h"
#include "app/print_stages.h"
#include "results/findings.h"
#include "runstore/staged_folder.h"
#include "study/run/prepared_case.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

void print_summary(const OperationResults& results) {
  const std::size_t all = results.stages.size();
  std::cout << fmt::format("  {} of {} {} found in {:.2f} s\n", count_solved(results), all,
                           all == 1 ? "equilibrium" : "equilibria", results.wall_time);
  std::cout << verdict_line(operation_verdict(results)) << finding_lines(operation_findings(results));
}

}  // namespace

int run_static_operation(const Description& description, const std::filesystem::path& folder, bool strict) {
  if (const auto unsupported = unsupported_in_operation(description)) {
    return report_status(failure_result(*unsupported, description));
  }
  std::cout << description.title << "\n" << stage_heads(description.operation.type);
  const auto report_stage = [](const StageResult& stage, std::size_t) {
    std::cout << stage_line(stage) << std::flush;
    return true;
  };
  const OperationResults results = solve_operation(description, report_stage);
  try {
    write_operation_run(results, description, folder);
  } catch (const UnusableFolder& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
  print_summary(results);
  std::cout << "Results are in " << folder.string() << "\n";
  if (count_solved(results) == 0) {
    return report_status({RunStatus::no_solution, "no stage of the operation has an equilibrium"});
  }
  return strict_code(results, strict);
}

}  // namespace overbend
