/// Writes the comparison of several result folders: comparison.csv.
#pragma once

#include <filesystem>
#include <string>

#include "base/finding.h"
#include "results/folder_comparison.h"

namespace overbend {

/// Returns a table with a row per differing key (section "input"), per result ("result", engineering units, with the
/// change against the first folder in per cent) and per finding not common to all ("finding"); a column per folder.
std::string folder_comparison_table(const FolderComparison& comparison);

/// A finding not common to all folders.
struct PartialFinding {
  Finding finding;  ///< As in the first folder that has it.
  std::vector<bool> has;
};

/// Returns the findings not common to all. Findings with the same code and object count as one: their numbers differ
/// between folders as results do.
std::vector<PartialFinding> partial_findings(const FolderComparison& comparison);

/// Writes comparison.csv into an existing folder. Throws std::runtime_error if it cannot be written.
void write_folder_comparison(const FolderComparison& comparison, const std::filesystem::path& folder);

}  // namespace overbend
