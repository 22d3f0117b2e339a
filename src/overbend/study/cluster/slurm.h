/// Studies on a Slurm cluster: job arrays that share the study's folder. Only sbatch, squeue and scontrol are called;
/// the finished cases are known from the folder alone.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>

#include "study/cluster/slurm_job.h"

namespace overbend {

/// Slurm rejects a job or is not available; one-line message for the user.
class SlurmError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A submitted job array.
struct SlurmJob {
  std::string id;
  std::size_t count = 0;           ///< Number of tasks into which the cases are divided.
  std::vector<std::size_t> tasks;  ///< Tasks of this array.
};

/// Reads the arrays submitted for a study so far from DIR/slurm/jobs.json. Throws std::runtime_error if the file is
/// damaged.
std::vector<SlurmJob> slurm_jobs(const std::filesystem::path& folder);

/// Writes DIR/slurm/job.sh, submits an array for the cases of these numbers, and records it in DIR/slurm/jobs.json.
/// `cases` is the total number; a study that was submitted before keeps its number of tasks. `more`: options of the
/// command for every task. Throws SlurmError.
SlurmJob submit_to_slurm(const SlurmStudy& study, const SlurmOptions& options, std::size_t cases,
                         const std::vector<std::size_t>& open, const std::vector<std::string>& more = {});

/// Returns the queue states ("PENDING", "RUNNING") of the remaining tasks by number; empty if squeue fails. Jobs
/// unknown to Slurm have none.
std::optional<std::map<std::size_t, std::string>> slurm_queue(const std::vector<SlurmJob>& jobs);

}  // namespace overbend
