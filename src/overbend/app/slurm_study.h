/// `overbend study --on slurm`, `--watch` and `--resubmit`.
#pragma once

#include "study/cases/case_evaluation.h"
#include "study/cluster/slurm.h"

namespace overbend {

struct SlurmArguments {
  SlurmOptions options;
  bool resubmit = false;  ///< Cases that failed as well, and only where arrays were submitted before.
};

/// Submits the cases of the study that have no answer, opening its folder, and tells what was submitted. The exit code.
int submit_study(const CaseBase& base, const std::filesystem::path& file, const std::filesystem::path& folder,
                 const SlurmArguments& arguments);

/// Tells how many tasks and cases are where until nothing of the study is in the queue, or until interrupted. Where
/// Slurm does not answer, once. The exit code.
int watch_study(const CaseBase& base, const std::filesystem::path& folder);

}  // namespace overbend
