/// A goal seek into one folder.
#pragma once

#include <filesystem>

#include "results/operation_results.h"
#include "study/goal_seek/seek.h"

namespace overbend {

/// A search, and where it has an answer the whole statics there.
struct SeekRun {
  SeekResults results;
  Description answer;                         ///< The model with the values put in.
  StaticRun statics;                          ///< Of that model; empty without an answer.
  std::optional<OperationResults> operation;  ///< Of a lift or pull, in their place: all its stages.

  /// What there is to say of the answer.
  Findings findings() const;
};

/// Searches, then solves the model with the answer in it as any other. Throws as seek().
SeekRun run_seek(const Description& description, const SeekDescription& wanted, const std::function<bool()>& stop = {});

/// Writes the files of the statics, or of the stages, with the section `seek` in summary and report, seek.csv, and
/// model.yaml, the model with the values put in; without an answer only summary.json and seek.csv. Whole or not at all;
/// throws UnusableFolder.
void write_seek_run(const SeekRun& run, const Description& description, const std::filesystem::path& folder);

/// The text of the model with the values put in, comments and layout kept, for a file in `folder`: files that it names
/// beside itself are named from there.
std::string answered_text(const SeekRun& run, const std::filesystem::path& folder);

}  // namespace overbend
