#include "app/study_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <map>
#include <thread>

#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "app/interruption.h"
#include "app/operability_lines.h"
#include "app/slurm_study.h"
#include "app/study_lines.h"
#include "modelfile/study_file/study_reader.h"
#include "runstore/staged_folder.h"
#include "study/campaign/study_findings.h"
#include "study/campaign/whole_study.h"
#include "study/operability/operability_folder.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

fs::path folder_of(const StudyArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  if (fs::is_directory(arguments.study_file)) return arguments.study_file;
  return fs::path(arguments.study_file).stem().string() + ".study";
}

/// "3/40"; nothing where it is none.
std::optional<std::pair<std::size_t, std::size_t>> tasks_of(const std::string& text) {
  std::size_t task = 0, tasks = 0;
  const char* end = text.data() + text.size();
  const auto [slash, fault] = std::from_chars(text.data(), end, task);
  if (fault != std::errc() || slash == end || *slash != '/') return std::nullopt;
  const auto [stop, second] = std::from_chars(slash + 1, end, tasks);
  if (second != std::errc() || stop != end || tasks == 0 || task >= tasks) return std::nullopt;
  return std::pair(task, tasks);
}

/// Exit code of a study that has run.
int code_of(const StudyResults& results, bool strict) {
  std::size_t done = 0, passed = 0;
  for (const StudyCase& one : results.cases) {
    done += one.state == StudyCaseState::done ? 1 : 0;
    passed += one.state == StudyCaseState::done && one.passed() ? 1 : 0;
  }
  if (done == 0 && !results.cases.empty()) {
    std::cerr << "overbend: no case of the study has a solution\n";
    return kNoSolution;
  }
  if (strict && passed < results.cases.size()) {
    std::cerr << fmt::format("overbend: {} of {} cases do not pass\n", results.cases.size() - passed,
                             results.cases.size());
    return kCheckExceeded;
  }
  return kDone;
}

/// What the study gave, on the terminal.
int tell_study(const StudyResults& results, const fs::path& folder, const StudyArguments& arguments) {
  if (!results.operability) {
    std::cout << study_lines(results, arguments.study_file, folder.string());
    return code_of(results, arguments.strict);
  }
  std::cout << operability_lines(*results.operability) << "Results are in " << folder.string() << "\n";
  if (std::ranges::any_of(results.operability->cells, &OperabilityCell::decided)) return kDone;
  std::cerr << "overbend: no limit could be decided\n";
  return kNoSolution;
}

int gather(const fs::path& folder, const StudyArguments& arguments) {
  try {
    refresh_operability(folder);
    return tell_study(gather_study(folder), folder, arguments);
  } catch (const FileFault&) {
    throw;
  } catch (const std::runtime_error& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
}

/// One case alone, with its files.
int run_alone(const CaseBase& base, const StudyCases& cases, const fs::path& folder, std::size_t number) {
  if (number >= cases.count()) {
    return tell(
        {RunEnding::wrong_input, fmt::format("--case {}: the study has cases 0 to {}", number, cases.count() - 1)});
  }
  const Interruption interruption;
  open_study(base, cases, folder);
  const StudyCase one = run_study_case(base, cases, folder, number, Interruption::wanted);
  if (one.state == StudyCaseState::open) {
    std::cerr << "overbend: interrupted; the same command continues the case\n";
    return kInterrupted;
  }
  std::cout << case_lines(one, cases.inputs(), study_outputs(base)) << finding_lines(one.findings);
  if (one.state == StudyCaseState::failed) return tell({RunEnding::no_solution, one.reason});
  std::cout << "Results are in " << (folder / one.folder).string() << "\n";
  return kDone;
}

/// First, middle and last case, one after the other into a folder that is thrown away; of dynamic analyses not longer
/// than some seconds each.
int dry_run(const CaseBase& base, const StudyCases& cases, int threads) {
  const bool searches = base.study().operability.has_value();
  std::cout << (searches ? search_line(OperabilityPlan(base.study())) : case_list(cases, base)) << std::flush;
  const StudyProbe probe = probe_study(base, cases, [] { return Interruption::wanted(); });
  const std::size_t cores =
      threads > 0 ? static_cast<std::size_t>(threads) : std::max<std::size_t>(1, std::thread::hardware_concurrency());
  std::cout << (searches ? search_probe_lines(probe, OperabilityPlan(base.study()), cores)
                         : probe_lines(probe, cases.count(), std::min(cores, cases.count())));
  return kDone;
}

int run_all(const CaseBase& base, const fs::path& folder, const StudyArguments& arguments) {
  StudyRunOptions options{arguments.threads, arguments.retry_failed};
  options.checkpoint_every = arguments.checkpoint_every;
  options.tables = arguments.tasks.empty();
  if (!arguments.tasks.empty()) {
    const auto tasks = tasks_of(arguments.tasks);
    if (!tasks) {
      return tell({RunEnding::wrong_input, "--tasks " + arguments.tasks + ": expected I/N with I from 0 to N - 1"});
    }
    std::tie(options.task, options.tasks) = *tasks;
  }
  const bool searches = base.study().operability.has_value();
  if (searches) std::cout << search_line(OperabilityPlan(base.study())) << std::flush;
  WholeStudy whole;
  {
    const Interruption interruption;
    FollowedCases watch(base.study());
    whole = run_whole_study(base, folder, options, watch);
  }
  const StudyTally& tally = whole.tally;
  if (whole.ending == RunEnding::interrupted) {
    std::cerr << (searches ? std::string("overbend: interrupted; the same command goes on\n")
                           : fmt::format("overbend: interrupted after {} cases; the same command goes on\n",
                                         tally.before + tally.done + tally.failed));
    return kInterrupted;
  }
  if (whole.ending != RunEnding::done) return tell(whole);
  if (!searches) std::cerr << tally_line(tally);
  return options.tables ? tell_study(whole.results, folder, arguments) : kDone;
}

}  // namespace

int run_study_command(const StudyArguments& arguments) {
  const fs::path folder = folder_of(arguments);
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
  } catch (const UnusableFolder& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
}

}  // namespace overbend
