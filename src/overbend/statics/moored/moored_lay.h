/// The equilibrium of a model: of a lay, of a hull on mooring lines with a pipe or without one, of lines by themselves.
#pragma once

#include "base/assumption.h"
#include "results/lift_results.h"
#include "results/line_results.h"
#include "results/mooring_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Whether a lay has mooring lines, or dynamic positioning: statics find where its vessel lies.
bool is_moored_lay(const Description& description);

/// What statics find of a model, whatever it has: a pipe that is laid, a hull on its lines, lines by themselves.
struct ModelEquilibrium {
  std::optional<StaticSolution> solution{};  ///< What the next statics, and a run in time, start from.
  std::optional<MooringResults> moorings{};  ///< Of a hull on mooring lines, or by dynamic positioning.
  std::vector<LineResult> lines{};           ///< That stand by themselves.
  std::optional<LiftResults> lift{};         ///< Of lines that hold each other.
  std::vector<BodyResult> bodies{};          ///< Of the bodies besides the vessel, and of a vessel that lines hold.
  // Of all but the pipe, whose results are recovered from the solution.
  Assumptions assumptions{};
  Findings findings{};
  std::optional<StaticFailure> failure{};
};

/// The equilibrium of a model; sets `model.mean_pose`, and `model.supports` to where a stinger on hinges comes to rest.
/// `start` and `past` serve a pipe, as in solve_statics().
ModelEquilibrium solve_equilibrium(Model& model, const StaticSolution* start = nullptr, const LinePast& past = {});

/// What is asked of lines that stand by themselves and cannot be solved.
std::optional<StaticFailure> lines_obstacle(const Description& description);

/// Of lines by themselves, on bodies that stay where they are drawn and a vessel that does, or floats free.
ModelEquilibrium solve_lines(const Model& model);

/// Rest of a hull on its lines or by dynamic positioning without a pipe, and the stages of its operation; sets
/// `model.mean_pose` to where it lies. The solution has no more than what a run in time starts from: pose, lines, what
/// the winches do.
ModelEquilibrium solve_moored_hull(Model& model);

/// Finds the equilibrium of the lay, and sets `model.mean_pose` to where the vessel comes to lie and `model.supports`
/// to where a stinger on hinges comes to rest (statics/stinger/stinger_rest.h). Without mooring lines
/// and dynamic positioning it is that of the pipe on the vessel as described.
///
/// With them pipe and hull take turns: what the pipe does to the vessel is a load on the hull on its lines, whose rest
/// is a new place for the pipe's supports, until nothing moves. The hull's restoring is stiff beside the change of that
/// load with the pose, so that a few turns do; it does not fail where the pipe on a held vessel does not. `start`
/// and `past` as for solve_statics.
///
/// Where the tension is a result, steel that yields is bent by the tension found before, until that stays.
ModelEquilibrium solve_lay(Model& model, const StaticSolution* start = nullptr, const LinePast& past = {});

}  // namespace overbend
