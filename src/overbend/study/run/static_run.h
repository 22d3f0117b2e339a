/// Statics of a model and their files, whatever it has: a pipe, a hull on its lines, lines by themselves.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"
#include "statics/moored/moored_lay.h"

namespace overbend {

/// Results of an equilibrium with the table of code checks, or why there are none.
struct StaticRun {
  std::optional<StaticResults> results;
  std::optional<StaticSolution> solution;  ///< What the next one, or a run in time, starts from.
  std::optional<StaticFailure> failure;
};

/// `start`: of a lay close by; sets `model.mean_pose` as solve_equilibrium does.
StaticRun run_statics(Model& model, const StaticSolution* start = nullptr);

/// Results of an equilibrium with the table of code checks.
StaticResults checked_statics(const Model& model, const ModelEquilibrium& equilibrium);

// Its two steps, for who may do without the second, which solves the same lay in still water where the checks need it.

StaticResults unjudged_statics(const Model& model, const ModelEquilibrium& equilibrium);
/// Adds what the current adds, and the code checks. The lay in still water starts from `still` where there is one, and
/// is left there.
void judge_statics(const Model& model, const StaticSolution& solution, StaticResults& results,
                   std::optional<StaticSolution>& still);

/// Adds what the assumptions on friction and on the loading history of yielding steel decide, of a pipe:
/// statics/recovery/friction_cases.h, statics/recovery/history_effect.h. Solves some more lays, each from this one.
void tell_friction(Model model, const StaticSolution& solution, StaticResults& results);

/// Adds what is told of a floating hull: radiation, damping, steady loads; with its warnings and assumptions. Takes a
/// part of a second for a hull with hydrodynamic coefficients.
void tell_hull(const Model& model, StaticResults& results);

/// Writes the files of a static analysis and its report, with what the results hang on where given, whole or not at
/// all. Throws UnusableFolder (runstore/staged_folder.h) when the folder cannot be.
void write_static_run(const StaticResults& results, const Description& description, const std::filesystem::path& folder,
                      const SensitivityResults* sensitivities = nullptr);

}  // namespace overbend
