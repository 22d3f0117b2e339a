/// Dynamic runs in parallel, one thread each: progress, interruption, resuming.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/dynamic_realisation.h"

namespace overbend {

/// One of them.
struct SideRun {
  const DynamicCase* shared = nullptr;  ///< May be another for each run.
  std::uint64_t seed = 1;
  std::filesystem::path folder;  ///< Of its results, its own.
  bool ended = false;            ///< Well or not, in this sitting or one before.
  RealisationEnd end{};          ///< Without the results: those are in its folder.
};

struct SideOptions {
  bool resume = false;             ///< Finished runs are kept, begun ones taken up.
  double checkpoint_every = 30.0;  ///< Of each run [s].
  int threads = 0;                 ///< Runs at work at the same time; 0: as many as there are cores.
  bool strict = false;             ///< kCheckExceeded where a governing code check of a run is exceeded.
};

/// Runs all into their folders; what they give does not depend on the number of threads. One that fails does not stop
/// the others. kDone when each has ended, well or not; kWrongInput when what is to be resumed is of another input, and
/// kInterrupted, both told on stderr. `noun` names the runs in the line of progress: "seeds".
ExitCode run_side_by_side(std::vector<SideRun>& runs, const SideOptions& options, const std::string& noun);

/// When every one failed for a reason that is the input's: tells it, removes `folder` where nothing else is in it.
bool all_wrong(const std::vector<SideRun>& runs, const std::filesystem::path& folder);

}  // namespace overbend
