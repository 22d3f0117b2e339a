#include "app/slurm_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <thread>

#include "app/exit_code.h"
#include "app/interruption.h"
#include "base/text.h"
#include "platform/process.h"
#include "study/campaign/study_folder.h"
#include "study/campaign/study_units.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Returns the path of this program, for the tasks of the array.
fs::path this_program() {
  fs::path program = executable_path();
  if (program.empty()) throw SlurmError("the path of this program cannot be found");
  return program;
}

std::string state_line(const StudyUnits& units, const std::map<std::size_t, std::string>* queue) {
  std::string line = fmt::format("{} of {} done", units.count - units.open.size(), units.count);
  if (!units.failed.empty()) line += fmt::format(", {} of them failed", units.failed.size());
  if (queue == nullptr) return line + "; squeue does not answer";
  std::map<std::string, int> states;
  for (const auto& [task, state] : *queue) ++states[state];
  for (const auto& [state, count] : states) line += fmt::format("; tasks {}: {}", state, count);
  return line;
}

bool wait_for(std::chrono::milliseconds time) {
  constexpr std::chrono::milliseconds kStep{100};
  for (; time.count() > 0 && !Interruption::wanted(); time -= kStep) std::this_thread::sleep_for(kStep);
  return !Interruption::wanted();
}

int submit(const CaseBase& base, const fs::path& file, const fs::path& folder, const SlurmArguments& arguments) {
  open_study(base, StudyCases(base.study()), folder);
  const std::vector<SlurmJob> before = slurm_jobs(folder);
  if (arguments.resubmit && before.empty()) {
    throw SlurmError("no case of this study has been submitted yet; use --on slurm");
  }
  StudyUnits units = study_units(base, folder);
  std::vector<std::size_t> open = units.open;
  std::vector<std::string> more;
  if (arguments.resubmit && !units.failed.empty()) {
    open.insert(open.end(), units.failed.begin(), units.failed.end());
    more.emplace_back("--retry-failed");
  }
  const SlurmStudy study{this_program(), fs::absolute(file), fs::absolute(folder)};
  const SlurmJob job = submit_to_slurm(study, arguments.options, units.count, open, more);
  std::cout << fmt::format("Job {}: {} of {} tasks for {} of {} {}\n", job.id, job.tasks.size(), job.count, open.size(),
                           units.count, base.study().operability ? "rows of the chart" : "cases");
  std::cout << fmt::format("Follow with: overbend study {} -o {} --watch\n", shell_word(file.string()),
                           shell_word(folder.string()));
  return kDone;
}

}  // namespace

int submit_study(const CaseBase& base, const fs::path& file, const fs::path& folder, const SlurmArguments& arguments) {
  try {
    return submit(base, file, folder, arguments);
  } catch (const SlurmError& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
}

int watch_study(const CaseBase& base, const fs::path& folder) {
  constexpr std::chrono::milliseconds kPause{5000};
  const Interruption interruption;
  std::string last;
  for (;;) {
    const auto queue = slurm_queue(slurm_jobs(folder));
    const StudyUnits units = study_units(base, folder);
    const std::string line = state_line(units, queue ? &*queue : nullptr);
    if (line != last) std::cout << line << std::endl;
    last = line;
    if (!queue) return kNoSolution;
    if (queue->empty()) {
      if (!units.open.empty()) std::cout << "Some cases have no result; --resubmit submits them again\n";
      return kDone;
    }
    if (!wait_for(kPause)) return kInterrupted;
  }
}

}  // namespace overbend
