#include "study/cluster/slurm_job.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/text.h"

namespace overbend {
namespace {

/// sbatch replaces patterns after a per cent sign in file names.
std::string file_pattern(const std::filesystem::path& folder) {
  std::string text;
  for (const char c : folder.string()) text += c == '%' ? "%%" : std::string(1, c);
  return text + "/slurm/log/%A_%a.out";
}

}  // namespace

std::string slurm_script(const SlurmStudy& study) {
  return "#!/bin/sh\n"
         "# One task of a study, written by overbend study --on slurm.\n"
         "count=$1\n"
         "shift\n"
         "exec " +
         shell_word(study.program.string()) + " study " + shell_word(study.file.string()) + " -o " +
         shell_word(study.folder.string()) + " --threads 1 --tasks \"$SLURM_ARRAY_TASK_ID/$count\" \"$@\"\n";
}

std::size_t task_count(std::size_t cases, std::size_t cases_per_task, std::size_t max_tasks) {
  const std::size_t per_task = std::max<std::size_t>(1, cases_per_task);
  const std::size_t wanted = cases / per_task + (cases % per_task != 0 ? 1 : 0);
  return std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(1, max_tasks));
}

std::string array_argument(const std::vector<std::size_t>& tasks, std::size_t limit) {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t last = i;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += std::to_string(tasks[i]);
    if (last > i) text += '-' + std::to_string(tasks[last]);
    i = last + 1;
  }
  return limit > 0 ? text + '%' + std::to_string(limit) : text;
}

std::vector<std::string> sbatch_command(const SlurmStudy& study, const SlurmOptions& options,
                                        const std::vector<std::size_t>& tasks, std::size_t count,
                                        const std::vector<std::string>& more) {
  std::vector<std::string> command = {"sbatch",
                                      "--parsable",
                                      "--job-name=overbend",
                                      "--ntasks=1",
                                      "--cpus-per-task=1",
                                      "--open-mode=append",
                                      "--output=" + file_pattern(study.folder),
                                      "--array=" + array_argument(tasks, options.array_limit)};
  if (!options.partition.empty()) command.push_back("--partition=" + options.partition);
  if (!options.time.empty()) command.push_back("--time=" + options.time);
  command.push_back((study.folder / "slurm" / "job.sh").string());
  command.push_back(std::to_string(count));
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

std::vector<std::size_t> find_tasks(const std::vector<std::size_t>& cases, std::size_t count) {
  std::set<std::size_t> tasks;
  for (const std::size_t number : cases) tasks.insert(number % count);
  return {tasks.begin(), tasks.end()};
}

}  // namespace overbend
