/// Static equilibrium of a model: a lay, a hull on mooring lines with or without a pipe, or lines only.
#pragma once

#include "base/assumption.h"
#include "results/lift_results.h"
#include "results/line_results.h"
#include "results/mooring_results.h"
#include "statics/solver/statics.h"

namespace overbend {

/// True if a lay has mooring lines or dynamic positioning: statics find the vessel's pose.
bool is_moored_lay(const Description& description);

/// Static results of any model: a laid pipe, a hull on its lines, or lines only.
struct ModelEquilibrium {
  std::optional<StaticSolution> solution{};  ///< Start of the next static analysis and of a time-domain simulation.
  std::optional<MooringResults> moorings{};  ///< Results of mooring lines or dynamic positioning.
  std::vector<LineResult> lines{};           ///< Lines without a lay.
  std::optional<LiftResults> lift{};         ///< Results of lines attached to each other.
  std::vector<BodyResult> bodies{};          ///< Bodies other than the vessel, and a vessel held by lines.
  // For everything except the pipe, whose results are recovered from the solution.
  Assumptions assumptions{};
  Findings findings{};
  std::optional<StaticFailure> failure{};
};

/// Finds the equilibrium of a model; sets `model.mean_pose`, and `model.supports` to the equilibrium of a hinged
/// stinger. `start` and `past`: for a pipe, as in solve_statics().
ModelEquilibrium solve_equilibrium(Model& model, const StaticSolution* start = nullptr, const LoadHistory& past = {});

/// Returns a failure for unsupported features of lines without a lay.
std::optional<StaticFailure> unsupported_lines(const Description& description);

/// Equilibrium of lines only, on bodies in their nominal poses and a vessel that is held there or floats freely.
ModelEquilibrium solve_lines(const Model& model);

/// Equilibrium of a hull on its lines or with dynamic positioning, without a pipe, and the stages of its operation;
/// sets `model.mean_pose`. The solution contains only the start of a time-domain simulation: pose, lines, winch
/// lengths.
ModelEquilibrium solve_moored_hull(Model& model);

/// Finds the equilibrium of the lay, and sets `model.mean_pose` to the vessel's pose and `model.supports` to the
/// equilibrium of a hinged stinger (statics/stinger/stinger_equilibrium.h). Without mooring lines and dynamic
/// positioning the vessel has its given pose.
///
/// With them pipe and hull are solved alternately: the pipe loads the hull on its lines, whose equilibrium is the new
/// pose of the pipe's supports, until the pose converges. The hull's restoring is stiff compared with the change of
/// that load with the pose, so that a few iterations suffice; the method fails only if the pipe on a held vessel does.
/// `start` and `past` as for solve_statics.
///
/// If the tension is a result, yielding steel uses the tension of the previous solution, iterated to convergence.
ModelEquilibrium solve_lay(Model& model, const StaticSolution* start = nullptr, const LoadHistory& past = {});

}  // namespace overbend
