/// Texts of a Slurm job array that runs a study. Pure functions; study/cluster/slurm.h passes them to Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace overbend {

/// Options of the jobs.
struct SlurmOptions {
  std::string partition;           ///< Empty: the cluster's default.
  std::string time;                ///< Time limit of a task in the format of sbatch; empty: the partition's.
  std::size_t cases_per_task = 0;  ///< 0: chosen by task_count().
  std::size_t array_limit = 0;     ///< Maximum number of concurrent tasks; 0: no limit.
};

/// Program, file and folder of a study.
struct SlurmStudy {
  std::filesystem::path program;  ///< This program, on the shared folder or at the same path on every node.
  std::filesystem::path file;     ///< Study file.
  std::filesystem::path folder;   ///< Folder of the study, on the shared folder.
};

/// Returns the script of one task: the cases of task $SLURM_ARRAY_TASK_ID; the first argument is the number of tasks,
/// further arguments are passed on.
std::string slurm_script(const SlurmStudy& study);

/// Number of tasks of an array for so many cases, at most `largest` (the cluster's MaxArraySize).
std::size_t task_count(std::size_t cases, std::size_t cases_per_task, std::size_t max_tasks);

/// Returns task numbers in the format of sbatch, "0-3,7", with "%LIMIT" appended if there is a limit.
std::string array_argument(const std::vector<std::size_t>& tasks, std::size_t limit);

/// Returns the command line of sbatch, as a list of arguments.
std::vector<std::string> sbatch_command(const SlurmStudy& study, const SlurmOptions& options,
                                        const std::vector<std::size_t>& tasks, std::size_t count,
                                        const std::vector<std::string>& more);

/// Returns the tasks that have any of these open cases: case i belongs to task i modulo count.
std::vector<std::size_t> find_tasks(const std::vector<std::size_t>& cases, std::size_t count);

}  // namespace overbend
