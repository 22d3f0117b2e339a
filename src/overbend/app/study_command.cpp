#include "app/study_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>

#include "app/exit_code.h"
#include "app/interruption.h"
#include "app/print_findings.h"
#include "app/print_operability.h"
#include "app/print_study.h"
#include "app/slurm_study.h"
#include "base/ranges.h"
#include "modelfile/study_file/study_reader.h"
#include "platform/machine.h"
#include "runstore/append_file.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_execution.h"
#include "study/campaign/study_findings.h"
#include "study/operability/operability_folder.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

fs::path find_study_folder(const StudyArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  if (fs::is_directory(arguments.study_file)) return arguments.study_file;
  return fs::path(arguments.study_file).stem().string() + ".study";
}

/// Parses "3/40"; nothing if invalid.
std::optional<std::pair<std::size_t, std::size_t>> parse_tasks(const std::string& text) {
  std::size_t task = 0, tasks = 0;
  const char* end = text.data() + text.size();
  const auto [slash, error] = std::from_chars(text.data(), end, task);
  if (error != std::errc() || slash == end || *slash != '/') return std::nullopt;
  const auto [stop, second] = std::from_chars(slash + 1, end, tasks);
  if (second != std::errc() || stop != end || tasks == 0 || task >= tasks) return std::nullopt;
  return std::pair(task, tasks);
}

/// Returns the exit code of a study.
int study_exit_code(const StudyResults& results, bool strict) {
  std::size_t done = 0, passed = 0;
  for (const StudyCase& study_case : results.cases) {
    done += study_case.state == StudyCaseState::done ? 1 : 0;
    passed += study_case.state == StudyCaseState::done && study_case.passed() ? 1 : 0;
  }
  if (done == 0 && !results.cases.empty()) {
    std::cerr << "overbend: no case of the study has a solution\n";
    return kNoSolution;
  }
  if (strict && passed < results.cases.size()) {
    std::cerr << fmt::format("overbend: {} of {} cases did not pass\n", results.cases.size() - passed,
                             results.cases.size());
    return kCheckExceeded;
  }
  return kDone;
}

/// Prints the results of a study and returns the exit code.
int report_study(const StudyResults& results, const fs::path& folder, const StudyArguments& arguments) {
  if (!results.operability) {
    std::cout << study_lines(results, arguments.study_file, folder.string());
    return study_exit_code(results, arguments.strict);
  }
  std::cout << operability_lines(*results.operability) << "Results are in " << folder.string() << "\n";
  if (ranges::any_of(results.operability->cells, &OperabilityCell::decided)) return kDone;
  std::cerr << "overbend: no limit was found\n";
  return kNoSolution;
}

int gather(const fs::path& folder, const StudyArguments& arguments) {
  try {
    refresh_operability(folder);
    return report_study(gather_study(folder), folder, arguments);
  } catch (const FileError&) {
    throw;
  } catch (const std::runtime_error& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
}

/// Runs a single case with its files.
int run_alone(const CaseBase& base, const StudyCases& cases, const fs::path& folder, std::size_t number) {
  if (number >= cases.count()) {
    return report_status(
        {RunStatus::wrong_input, fmt::format("--case {}: the study has cases 0 to {}", number, cases.count() - 1)});
  }
  const Interruption interruption;
  open_study(base, cases, folder);
  const StudyCase study_case = run_study_case(base, cases, folder, number, Interruption::wanted);
  if (study_case.state == StudyCaseState::open) {
    std::cerr << "overbend: interrupted; run the same command to continue the case\n";
    return kInterrupted;
  }
  std::cout << case_lines(study_case, cases.inputs(), study_outputs(base)) << finding_lines(study_case.findings);
  if (study_case.state == StudyCaseState::failed) return report_status({RunStatus::no_solution, study_case.reason});
  std::cout << "Results are in " << (folder / study_case.folder).string() << "\n";
  return kDone;
}

/// Runs the first, middle and last case in a temporary folder, dynamic analyses only for a few seconds each, and prints
/// an estimate of the run time.
int dry_run(const CaseBase& base, const StudyCases& cases, int threads) {
  const bool searches = base.study().operability.has_value();
  std::cout << (searches ? search_line(OperabilityPlan(base.study())) : case_list(cases, base)) << std::flush;
  const StudyProbe probe = probe_study(base, cases, [] { return Interruption::wanted(); });
  const std::size_t cores = threads > 0 ? static_cast<std::size_t>(threads) : hardware_threads();
  std::cout << (searches ? search_probe_lines(probe, OperabilityPlan(base.study()), cores)
                         : probe_lines(probe, cases.count(), std::min(cores, cases.count())));
  return kDone;
}

int run_all(const CaseBase& base, const fs::path& folder, const StudyArguments& arguments) {
  StudyRunOptions options{arguments.threads, arguments.retry_failed};
  options.checkpoint_every = arguments.checkpoint_every;
  options.tables = arguments.tasks.empty();
  if (!arguments.tasks.empty()) {
    const auto tasks = parse_tasks(arguments.tasks);
    if (!tasks) {
      return report_status(
          {RunStatus::wrong_input, "--tasks " + arguments.tasks + ": expected I/N with I from 0 to N - 1"});
    }
    std::tie(options.task, options.tasks) = *tasks;
  }
  const bool searches = base.study().operability.has_value();
  if (searches) std::cout << search_line(OperabilityPlan(base.study())) << std::flush;
  StudyExecution outcome;
  {
    const Interruption interruption;
    CaseProgressPrinter watch(base.study());
    outcome = execute_study(base, folder, options, watch);
  }
  const StudyTally& tally = outcome.tally;
  if (outcome.ending == RunStatus::interrupted) {
    std::cerr << (searches ? std::string("overbend: interrupted; run the same command to continue\n")
                           : fmt::format("overbend: interrupted after {} cases; run the same command to continue\n",
                                         tally.before + tally.done + tally.failed));
    return kInterrupted;
  }
  if (outcome.ending != RunStatus::done) return report_status(outcome);
  if (!searches) std::cerr << tally_line(tally);
  return options.tables ? report_study(outcome.results, folder, arguments) : kDone;
}

}  // namespace

int run_study_command(const StudyArguments& arguments) {
  const fs::path folder = find_study_folder(arguments);
  if (arguments.gather) return gather(folder, arguments);
  StudyReading reading = read_study_file(arguments.study_file);
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) std::cerr << line << "\n";
  if (!reading.study) return kWrongInput;
  const CaseBase base(std::move(*reading.base), std::move(*reading.study));
  const StudyCases cases(base.study());
  if (arguments.watch) return watch_study(base, folder);
  std::cout << study_head(base, cases) << finding_lines(study_findings(base, cases)) << std::flush;
  try {
    if (!arguments.on.empty() || arguments.resubmit) {
      return submit_study(base, arguments.study_file, folder, {arguments.slurm, arguments.resubmit});
    }
    if (arguments.dry_run) return dry_run(base, cases, arguments.threads);
    if (arguments.only) return run_alone(base, cases, folder, *arguments.only);
    return run_all(base, folder, arguments);
  } catch (const UnusableFolder& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
}

}  // namespace overbend
