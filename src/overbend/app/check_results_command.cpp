#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/check_lines.h"
#include "app/commands.h"
#include "resultfiles/stages/operation_reader.h"
#include "results/findings.h"
#include "results/worst_stage.h"
#include "runstore/staged_folder.h"
#include "study/run/recheck.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

int refuse(const std::string& why) {
  std::cerr << "overbend: " << why << "\n";
  return kWrongInput;
}

/// Why results cannot go into a folder; empty where they can.
std::string output_obstacle(const fs::path& output, std::size_t runs) {
  if (runs > 1) return "--output takes the results of one run; give the folder of one of these";
  std::error_code fault;
  if (fs::exists(output, fault) && !fs::is_empty(output, fault)) {
    return "the folder " + output.string() + " is not empty; give a new one";
  }
  return "";
}

/// The stages of an operation on the line, one after the other.
ExitCode check_operation(const fs::path& h5, const CheckResultsArguments& arguments) {
  const RecheckedOperation again = recheck_operation(h5, arguments.changes);
  std::cout << again.results.title << "\n";
  for (const StageResult& stage : again.results.stages) {
    std::cout << stage.stage.name << "\n" << (stage.lay ? check_lines(stage.lay->checks) : "  no equilibrium\n");
  }
  if (!arguments.output.empty()) {
    write_operation_run(again.results, again.description, arguments.output);
    std::cout << "Results are in " << arguments.output << "\n";
  }
  const StageResult* worst = worst_stage(again.results);
  const Findings findings = operation_findings(again.results);
  return worst != nullptr ? strict_code(worst->lay->checks, findings, arguments.strict) : kDone;
}

ExitCode check_run(const fs::path& h5, const CheckResultsArguments& arguments, bool named) {
  if (has_lay_operation(h5)) return check_operation(h5, arguments);
  const Rechecked again = recheck(h5, arguments.changes);
  std::cout << again.statics.title << (named ? ", " + h5.parent_path().filename().string() : "") << "\n";
  std::cout << check_lines(again.checks()) << verdict_line(again.checks(), again.findings());
  if (!arguments.output.empty()) {
    write_rechecked(again, h5, arguments.output);
    std::cout << "Results are in " << arguments.output << "\n";
  }
  return strict_code(again.checks(), again.findings(), arguments.strict);
}

}  // namespace

int run_check_results(const CheckResultsArguments& arguments) {
  const std::vector<fs::path> files = result_files(arguments.place);
  if (files.empty()) return refuse("there are no results in " + arguments.place);
  if (!arguments.output.empty()) {
    const std::string obstacle = output_obstacle(arguments.output, files.size());
    if (!obstacle.empty()) return refuse(obstacle);
  }
  int code = kDone;
  try {
    for (const fs::path& h5 : files) code = std::max<int>(code, check_run(h5, arguments, files.size() > 1));
  } catch (const FileFault&) {  // the disk, not the user
    throw;
  } catch (const std::runtime_error& fault) {
    return refuse(fault.what());
  }
  return code;
}

}  // namespace overbend
