#include <algorithm>
#include <filesystem>
#include <iostream>

#include "app/commands.h"
#include "app/print_checks.h"
#include "app/print_stages.h"
#include "resultfiles/stages/operation_reader.h"
#include "results/findings.h"
#include "runstore/append_file.h"
#include "runstore/staged_folder.h"
#include "study/run/recheck.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

int reject(const std::string& why) {
  std::cerr << "overbend: " << why << "\n";
  return kWrongInput;
}

/// Returns the reason why results cannot be written to a folder; empty if they can.
std::string find_output_error(const fs::path& output, std::size_t runs) {
  if (runs > 1) return "--output accepts the results of one run; give the folder of one of these runs";
  std::error_code error;
  if (fs::exists(output, error) && !fs::is_empty(output, error)) {
    return "the folder " + output.string() + " is not empty; give a new one";
  }
  return "";
}

/// Checks the stages of an operation one after the other.
ExitCode check_operation(const fs::path& h5, const CheckResultsArguments& arguments) {
  const RecheckedOperation again = recheck_operation(h5, arguments.changes);
  std::cout << again.results.title << "\n";
  for (const StageResult& stage : again.results.stages) {
    std::cout << stage.stage.name << "\n" << (stage.lay ? check_lines(stage.lay->checks) : "  no equilibrium\n");
  }
  std::cout << verdict_line(operation_verdict(again.results));
  if (!arguments.output.empty()) {
    write_operation_run(again.results, again.description, arguments.output);
    std::cout << "Results are in " << arguments.output << "\n";
  }
  return strict_code(again.results, arguments.strict);
}

ExitCode check_run(const fs::path& h5, const CheckResultsArguments& arguments, bool named) {
  if (has_lay_operation(h5)) return check_operation(h5, arguments);
  const Rechecked again = recheck(h5, arguments.changes);
  std::cout << again.statics.title << (named ? ", " + h5.parent_path().filename().string() : "") << "\n";
  std::cout << check_lines(again.checks()) << verdict_line(make_verdict(again.checks(), again.findings()));
  if (!arguments.output.empty()) {
    write_rechecked(again, h5, arguments.output);
    std::cout << "Results are in " << arguments.output << "\n";
  }
  return strict_code(again.checks(), again.findings(), arguments.strict);
}

}  // namespace

int run_check_results(const CheckResultsArguments& arguments) {
  const std::vector<fs::path> files = result_files(arguments.place);
  if (files.empty()) return reject("there are no results in " + arguments.place);
  if (!arguments.output.empty()) {
    const std::string unsupported = find_output_error(arguments.output, files.size());
    if (!unsupported.empty()) return reject(unsupported);
  }
  int code = kDone;
  try {
    for (const fs::path& h5 : files) code = std::max<int>(code, check_run(h5, arguments, files.size() > 1));
  } catch (const FileError&) {  // the disk, not the user
    throw;
  } catch (const std::runtime_error& error) {
    return reject(error.what());
  }
  return code;
}

}  // namespace overbend
