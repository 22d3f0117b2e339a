/// Studies on a cluster that runs Slurm: job arrays that share the study's folder. Only sbatch, squeue and scontrol are
/// called; what is finished is known from the folder alone.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>

#include "study/cluster/slurm_job.h"

namespace overbend {

/// What Slurm refuses or does not have; one sentence for the user.
class SlurmFault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An array that was submitted.
struct SlurmJob {
  std::string id;
  std::size_t count = 0;           ///< Tasks that the cases are divided among.
  std::vector<std::size_t> tasks;  ///< Those of them that this array has.
};

/// The arrays submitted for a study so far, of DIR/slurm/jobs.json. Throws std::runtime_error where that is damaged.
std::vector<SlurmJob> slurm_jobs(const std::filesystem::path& folder);

/// Writes DIR/slurm/job.sh, submits an array for the cases of these numbers, and remembers it in DIR/slurm/jobs.json.
/// `cases` in all; a study that was submitted before keeps its number of tasks. `more`: options of the command for
/// every task. Throws SlurmFault.
SlurmJob submit_to_slurm(const SlurmStudy& study, const SlurmOptions& options, std::size_t cases,
                         const std::vector<std::size_t>& open, const std::vector<std::string>& more = {});

/// The state in the queue ("PENDING", "RUNNING") of tasks that are there still, by number; nothing where squeue cannot
/// tell. Jobs that Slurm has forgotten have none.
std::optional<std::map<std::size_t, std::string>> slurm_queue(const std::vector<SlurmJob>& jobs);

}  // namespace overbend
