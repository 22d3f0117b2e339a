/// Writes results of several folders beside each other: comparison.csv.
#pragma once

#include <filesystem>
#include <string>

#include "results/folder_comparison.h"

namespace overbend {

/// A row per differing key (section "input"), per result ("result", engineering units, with the change against the
/// first folder in per cent) and per warning that not all have ("warning"); a column per folder.
std::string folder_comparison_table(const FolderComparison& comparison);

/// The warnings that not all folders have, with whether each has it.
struct PartialWarning {
  std::string text;
  std::vector<bool> has;
};
std::vector<PartialWarning> partial_warnings(const FolderComparison& comparison);

/// comparison.csv into an existing folder. Throws std::runtime_error where it cannot be written.
void write_folder_comparison(const FolderComparison& comparison, const std::filesystem::path& folder);

}  // namespace overbend
