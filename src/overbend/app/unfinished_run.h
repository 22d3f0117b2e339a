/// What becomes of a run that was begun and not finished, when its folder is to be used again.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

namespace overbend {

/// What the command line says of it.
struct TakeUp {
  bool resume = false;   ///< Go on.
  bool restart = false;  ///< Begin anew.
};

/// Whether to go on from what the folders hold. Where something unfinished is there and the command line says nothing,
/// it asks at a terminal; elsewhere, or where the answer is neither, it tells on stderr what to do and gives none.
std::optional<bool> goes_on(const std::vector<std::filesystem::path>& folders, const TakeUp& wish);

}  // namespace overbend
