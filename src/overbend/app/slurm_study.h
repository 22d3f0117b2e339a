/// Options `--on slurm`, `--watch` and `--resubmit` of `overbend study`.
#pragma once

#include "study/cases/case_evaluation.h"
#include "study/cluster/slurm.h"

namespace overbend {

struct SlurmArguments {
  SlurmOptions options;
  bool resubmit = false;  ///< Also submit failed cases; requires an earlier submission.
};

/// Opens the folder of the study, submits the cases without a result, prints what was submitted and returns the exit
/// code.
int submit_study(const CaseBase& base, const std::filesystem::path& file, const std::filesystem::path& folder,
                 const SlurmArguments& arguments);

/// Prints the state of tasks and cases until no task of the study is in the queue or until interrupted; only once if
/// Slurm does not answer. Returns the exit code.
int watch_study(const CaseBase& base, const std::filesystem::path& folder);

}  // namespace overbend
