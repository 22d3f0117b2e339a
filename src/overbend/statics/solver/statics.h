/// Static equilibrium of the line: the S (or J) from nothing.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "moorings/move_path.h"
#include "results/static_results.h"
#include "statics/equations/static_system.h"

namespace overbend {

struct LinesAtRest;
struct StaticSolution;

/// How the line lay before it came to lie as it is looked for: its steel remembers.
struct LinePast {
  std::shared_ptr<const StaticSolution> solution;  ///< None: it has been laid as StaticSettings::history says.
  double shift = 0.0;                              ///< By how much the line has moved away from the top since [m].
  double across_rollers = 0.0;  ///< Factor of the rollers' full lateral friction, to port: 1, 0 or -1.
};

/// A stinger on hinges as it was found.
struct StingerAtRest {
  std::vector<double> angles;     ///< Of each section about its own hinge [rad].
  std::vector<double> stiffness;  ///< Fall of the moments with the angles of the floating ones, row by row [N m/rad].
  std::vector<double> angle_up, angle_down;  ///< Between which hinge friction may leave each section [rad].
  Findings findings;
};

/// An equilibrium with the mesh it stands on: enough to recover results, to start the next case, to start dynamics.
struct StaticSolution {
  StaticSolution();  // These six are compiled once: a copy of all members is long, and many sources make one.
  StaticSolution(const StaticSolution&);
  StaticSolution(StaticSolution&&) noexcept;
  StaticSolution& operator=(const StaticSolution&);
  StaticSolution& operator=(StaticSolution&&) noexcept;
  ~StaticSolution();

  LineMesh mesh;
  LineState state;
  SolveReport report;
  std::vector<BendingMemory> bending;  ///< What the steel has been through, per Gauss point; empty where none yields.
  std::vector<RollerPush> pushes;      ///< Of the rollers, where steel may yield: a line that moves on passes them.
  VesselPose pose;                     ///< Of the vessel.
  std::optional<MooringSpread> moorings;  ///< Its mooring lines with their lengths, where it has any.
  Mat6 station_stiffness = Mat6::Zero();  ///< Of these about the centre of gravity of a hull that floats [N/m, N, N m].
  std::optional<WinchPlan> winches;       ///< What they do when it is pulled ahead.
  std::shared_ptr<const LinesAtRest> lines;  ///< Those that stand by themselves (lines_setup.h), where there are any.
  LinePast past;                             ///< What it was solved from.
  StingerAtRest stinger;                     ///< Of a stinger on hinges, see statics/stinger/stinger_rest.h.
  std::optional<MeshZones> zones;            ///< What its mesh was made for.
  MeshDescription mesh_asked;                ///< Elements that the model asked for.

  bool has_pipe() const { return !mesh.length.empty(); }
};

/// The equations of a line on a mesh, with its past.
StaticSystem system_with_past(const Model& model, LineMesh mesh, const LinePast& past);

/// What a search for another tension may conclude from a failure.
enum class FailureKind {
  other,
  tension_too_low,  ///< The line cannot hang or would be in compression at the seabed.
  no_touchdown,     ///< The line ends before it reaches the seabed.
};

/// Why there is none.
struct StaticFailure {
  std::string what;    ///< One sentence: what went wrong.
  std::string where;   ///< Place along the line, empty where it is the whole.
  std::string why;     ///< The reason, and what would mend it.
  bool input = false;  ///< The model asks for what is not computed: to be told as a fault of the file.
  std::string key{};   ///< Of an input: the key of the model that it is about, empty where it is about none.
  FailureKind kind = FailureKind::other;
};

struct StaticOutcome {
  std::optional<StaticSolution> solution;
  std::optional<StaticFailure> failure;
};

/// Finds the equilibrium. `start`, where given, is the solution of a case close by (slider, continuation).
StaticOutcome solve_statics(const Model& model, const StaticSolution* start = nullptr, const LinePast& past = {});

/// The same from a neighbouring solution alone: where that does not lead to the equilibrium, nothing else is tried.
StaticOutcome continue_statics(const Model& model, const StaticSolution& start, const LinePast& past = {});

}  // namespace overbend
