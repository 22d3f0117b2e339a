/// Analyses of a model that is nothing but lines between two ends.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "dynamics/integrator/dynamics.h"
#include "recording/run_dynamics.h"
#include "results/line_results.h"
#include "results/seeds_results.h"

namespace overbend {

struct LinesOutcome {
  std::optional<LinesResults> results;
  std::optional<StaticFailure> failure;
  bool stopped = false;  ///< By who followed the run, after it kept a checkpoint.
};

/// Whether a model is lines by themselves and nothing else.
bool is_lines_alone(const Description& description);

/// The lines at rest.
LinesOutcome solve_lines(const Model& model);

/// The same and a run in time from there, without histories, which go to the sink. Throws std::invalid_argument for a
/// sea or a motion that cannot be made.
LinesOutcome run_lines(const Model& model, const DynamicOptions& options, DynamicSink& sink,
                       const DynamicCheckpoint* from,
                       const std::function<DynamicControl(const DynamicProgress&)>& control);

/// The same in a folder of results, where it can be taken up again; with `resume` from what the folder holds. Writes
/// the results. Throws besides UnusableFolder, and std::runtime_error where the folder holds a run of something else.
LinesOutcome run_lines_in(const std::filesystem::path& folder, const Model& model, const DynamicOptions& options,
                          bool resume, const std::function<DynamicControl(const DynamicProgress&)>& control);

/// What several seeds gave together.
struct LineSeeds {
  LinesResults last;  ///< Of the last seed that was done: the lines at rest are those of all.
  SeedsResults seeds;
  std::optional<StaticFailure> failure;  ///< Where no seed gave a result: why the last one did not.
  bool stopped = false;
};

/// Runs the seeds one after the other by `run`, which is told the seed and the name of its folder. One that fails is
/// listed and does not stop the others, unless what it asks for is not computed: then none does it.
LineSeeds run_line_seeds(const Description& description, const std::vector<std::uint64_t>& seeds,
                         const std::function<LinesOutcome(std::uint64_t, const std::string&)>& run);

/// Of several seeds: largest and smallest tensions at the ends of every line. `runs` as they ended.
SeedsResults gather_lines(const Description& description, const std::vector<SeedRun>& runs);
/// The values of a run, in the order of the quantities there.
std::vector<double> lines_values(const LinesResults& results);

/// Writes all files to `folder`, whole or not at all. Throws UnusableFolder.
void write_lines_run(const LinesResults& results, const Description& description, const std::filesystem::path& folder);

}  // namespace overbend
