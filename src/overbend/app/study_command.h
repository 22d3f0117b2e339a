/// Command `study`.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "study/cluster/slurm_job.h"

namespace overbend {

struct StudyArguments {
  std::string study_file, output;
  int threads = 0;                 ///< 0: one per core.
  double checkpoint_every = 60.0;  ///< Time between checkpoints of dynamic analyses [s].
  bool dry_run = false, retry_failed = false, gather = false, strict = false;
  std::optional<std::size_t> only;  ///< Number of a single case to run.
  std::string tasks;                ///< "I/N"
  std::string on;                   ///< "slurm", or empty: here.
  SlurmOptions slurm;
  bool watch = false, resubmit = false;  ///< Options of a study on Slurm.
};

int run_study_command(const StudyArguments& arguments);

}  // namespace overbend
