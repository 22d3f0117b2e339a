/// Texts of a Slurm job array that runs a study. Pure functions; study/cluster/slurm.h hands them to Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace overbend {

/// What the user may say of the jobs.
struct SlurmOptions {
  std::string partition;           ///< Empty: the cluster's default.
  std::string time;                ///< Limit of a task, as sbatch takes it; empty: the partition's.
  std::size_t cases_per_task = 0;  ///< 0: chosen, see task_count().
  std::size_t array_limit = 0;     ///< Tasks at work at the same time; 0: no limit.
};

/// What is run.
struct SlurmStudy {
  std::filesystem::path program;  ///< This program, on the shared folder or at the same place on every node.
  std::filesystem::path file;     ///< Study file.
  std::filesystem::path folder;   ///< Of the study, on the shared folder.
};

/// The script of one task: the cases of task $SLURM_ARRAY_TASK_ID of as many tasks as the first argument says; further
/// arguments are handed on.
std::string slurm_script(const SlurmStudy& study);

/// Tasks of an array for so many cases, at most `largest` (the cluster's MaxArraySize).
std::size_t task_count(std::size_t cases, std::size_t cases_per_task, std::size_t largest);

/// Numbers as sbatch takes them, "0-3,7", with "%LIMIT" behind where there is one.
std::string array_words(const std::vector<std::size_t>& tasks, std::size_t limit);

/// The command line of sbatch, word by word.
std::vector<std::string> sbatch_words(const SlurmStudy& study, const SlurmOptions& options,
                                      const std::vector<std::size_t>& tasks, std::size_t count,
                                      const std::vector<std::string>& more);

/// Tasks to which any of the cases belongs that are not done: case i is of task i modulo count.
std::vector<std::size_t> tasks_of(const std::vector<std::size_t>& cases, std::size_t count);

}  // namespace overbend
