/// Static equilibrium of the line: the S (or J) from nothing.
#pragma once

#include <optional>
#include <string>

#include "moorings/move_path.h"
#include "results/static_results.h"
#include "statics/static_system.h"

namespace overbend {

/// An equilibrium with the mesh it stands on: enough to recover results, to start the next case, to start dynamics.
struct StaticSolution {
  LineMesh mesh;
  LineState state;
  SolveReport report;
  std::vector<BendingMemory> bending;  ///< What the steel has been through, per Gauss point; empty where none yields.
  VesselPose pose;                     ///< Of the vessel.
  std::optional<MooringSpread> moorings;  ///< Its mooring lines with their lengths, where it has any.
  std::optional<WinchPlan> winches;       ///< What they do when it is pulled ahead.
};

/// Why there is none.
struct StaticFailure {
  std::string what;    ///< One sentence: what went wrong.
  std::string where;   ///< Place along the line, empty where it is the whole.
  std::string why;     ///< The reason, and what would mend it.
  bool input = false;  ///< The model asks for what is not computed: to be told as a fault of the file.
};

struct StaticOutcome {
  std::optional<StaticSolution> solution;
  std::optional<StaticFailure> failure;
};

/// Finds the equilibrium. `start`, where given, is the solution of a case close by (slider, continuation).
StaticOutcome solve_statics(const Model& model, const StaticSolution* start = nullptr);

}  // namespace overbend
