/// Statics into one folder.
#pragma once

#include <filesystem>

#include "model/description/description.h"
#include "results/sensitivity_results.h"
#include "results/static_results.h"
#include "statics/moored/moored_lay.h"

namespace overbend {

/// Results of an equilibrium with the table of code checks.
StaticResults checked_statics(const Model& model, const LayOutcome& lay);

// Its two steps, for who may do without the second, which solves the same lay in still water where the checks need it.

StaticResults unjudged_statics(const Model& model, const LayOutcome& lay);
/// Adds what the current adds, and the code checks. The lay in still water starts from `still` where there is one, and
/// is left there.
void judge_statics(const Model& model, const StaticSolution& solution, StaticResults& results,
                   std::optional<StaticSolution>& still);

/// Adds what the assumptions on friction and on the loading history of yielding steel decide:
/// statics/recovery/friction_cases.h, statics/recovery/history_effect.h. Solves some more lays, each from this one.
void tell_friction(Model model, const LayOutcome& lay, StaticResults& results);

/// Adds what is told of a floating hull: radiation, damping, steady loads; with its warnings and assumptions. Takes a
/// part of a second for a hull with hydrodynamic coefficients.
void tell_hull(const Model& model, StaticResults& results);
void tell_hull(const Model& model, MooringResults& results);

/// Writes the files of a static analysis and its report, with what the results hang on where given, whole or not at
/// all. Throws UnusableFolder
/// (runstore/staged_folder.h) when the folder cannot be.
void write_static_run(const StaticResults& results, const Description& description, const std::filesystem::path& folder,
                      const SensitivityResults* sensitivities = nullptr);

}  // namespace overbend
