/// Statics of any model and the files of results: a pipe, a hull on its lines, or lines only.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"
#include "statics/moored/moored_lay.h"

namespace overbend {

/// Results of an equilibrium with the table of code checks, or the failure.
struct StaticRun {
  std::optional<StaticResults> results;
  std::optional<StaticSolution> solution;  ///< Start of the next equilibrium, or of a dynamic run.
  std::optional<StaticFailure> failure;
};

/// Solves the statics of a model. `start`: solution of a neighbouring lay; sets `model.mean_pose` like
/// solve_equilibrium.
StaticRun run_statics(Model& model, const StaticSolution* start = nullptr);

/// Returns the results of an equilibrium with the table of code checks.
StaticResults checked_statics(const Model& model, const ModelEquilibrium& equilibrium);

// The two steps separately; the second may require an extra still-water solution.

StaticResults recover_without_checks(const Model& model, const ModelEquilibrium& equilibrium);
/// Adds the effect of the current and the code checks. The still-water solution starts from `still_water` if present
/// and is stored there.
void add_code_checks(const Model& model, const StaticSolution& solution, StaticResults& results,
                     std::optional<StaticSolution>& still_water);

/// Adds the effects of roller friction and of the loading history of yielding steel on a pipe:
/// statics/recovery/roller_friction_limits.h, statics/recovery/history_effect.h. Solves a few more lays, each from this
/// one.
void add_roller_friction_limits(Model model, const StaticSolution& solution, StaticResults& results);

/// Adds the results of a floating hull: radiation, damping, steady loads, with their warnings and assumptions. Takes a
/// fraction of a second for a hull with hydrodynamic coefficients.
void add_hull_results(const Model& model, StaticResults& results);

/// Writes the files of a static analysis and its report, with sensitivities if given, completely or not at all. Throws
/// UnusableFolder (runstore/staged_folder.h) if the folder cannot be used.
void write_static_run(const StaticResults& results, const Description& description, const std::filesystem::path& folder,
                      const SensitivityResults* sensitivities = nullptr);

}  // namespace overbend
