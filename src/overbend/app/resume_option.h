/// Resuming or restarting an unfinished run.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace overbend {

/// Choice on the command line.
struct ResumeOption {
  bool resume = false;   ///< Continue from the checkpoint.
  bool restart = false;  ///< Discard it and start again.
};

/// Returns true to resume, false to start a new run. If a folder holds an unfinished run and the command line states no
/// choice, asks on a terminal; otherwise, or without a valid answer, prints on stderr what to do and returns nothing.
std::optional<bool> resume_requested(const std::vector<std::filesystem::path>& folders, const ResumeOption& option);

}  // namespace overbend
