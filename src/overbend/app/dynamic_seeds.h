/// Several realisations of a sea side by side, and what they say together.
#pragma once

#include <filesystem>
#include <vector>

#include "app/side_by_side.h"

namespace overbend {

/// Where each seed's run and results are.
std::vector<std::filesystem::path> seed_folders(const std::filesystem::path& folder,
                                                const std::vector<std::uint64_t>& seeds);

/// Runs every seed into `folder`/seed-K and gathers their key values in `folder`. Results do not depend on the number
/// of threads. A seed that fails is listed and does not stop the others; the exit code is then kNoSolution, or
/// kWrongInput when none came to an end for a reason that is the input's.
int run_seeds(const DynamicCase& shared, const std::vector<std::uint64_t>& seeds, const std::filesystem::path& folder,
              const SideOptions& options);

}  // namespace overbend
