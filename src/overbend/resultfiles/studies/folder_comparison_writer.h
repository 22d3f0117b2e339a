/// Writes results of several folders beside each other: comparison.csv.
#pragma once

#include <filesystem>
#include <string>

#include "base/finding.h"
#include "results/folder_comparison.h"

namespace overbend {

/// A row per differing key (section "input"), per result ("result", engineering units, with the change against the
/// first folder in per cent) and per finding that not all have ("finding"); a column per folder.
std::string folder_comparison_table(const FolderComparison& comparison);

/// A finding that not all folders have, with whether each has it.
struct PartialFinding {
  Finding finding;  ///< Of the first folder that has it.
  std::vector<bool> has;
};

/// Findings of the same code and object are one: their numbers differ between folders as results do.
std::vector<PartialFinding> partial_findings(const FolderComparison& comparison);

/// comparison.csv into an existing folder. Throws std::runtime_error where it cannot be written.
void write_folder_comparison(const FolderComparison& comparison, const std::filesystem::path& folder);

}  // namespace overbend
