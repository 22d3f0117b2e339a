/// A goal seek with its files in one folder.
#pragma once

#include <filesystem>

#include "results/operation_results.h"
#include "study/goal_seek/seek.h"

namespace overbend {

/// A search, and the complete statics of its answer, if any.
struct SeekRun {
  SeekResults results;
  Description answer;                         ///< The model with the values of the answer.
  StaticRun statics;                          ///< Statics of that model; empty without an answer.
  std::optional<OperationResults> operation;  ///< All stages of a lift or pull, instead of the statics.

  /// Returns the findings of the answer.
  Findings findings() const;
};

/// Searches, then solves the model with the answer like any other. Throws like seek().
SeekRun run_seek(const Description& description, const SeekDescription& wanted, const std::function<bool()>& stop = {});

/// Writes the files of the statics, or of the stages, with the section `seek` in summary and report, seek.csv, and
/// model.yaml, the model with the values of the answer; without an answer only summary.json and seek.csv. Complete or
/// not at all; throws UnusableFolder.
void write_seek_run(const SeekRun& run, const Description& description, const std::filesystem::path& folder);

/// Returns the model text with the values of the answer, comments and layout kept, for a file in `folder`: paths of
/// files next to the model are rewritten relative to it.
std::string answered_text(const SeekRun& run, const std::filesystem::path& folder);

}  // namespace overbend
