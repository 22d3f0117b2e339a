/// Static equilibrium of the line (S-lay or J-lay), without an initial solution.
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

struct StaticLines;
struct StaticSolution;

/// Previous configuration of the line; needed for plastic history.
struct LoadHistory {
  std::shared_ptr<const StaticSolution> solution;  ///< If none, the laying history is StaticSettings::history.
  double shift = 0.0;                              ///< Displacement of the line away from the top since then [m].
  double across_rollers = 0.0;  ///< Factor of the rollers' full lateral friction, to port: 1, 0 or -1.
};

/// Angles of a hinged stinger in equilibrium.
struct StingerEquilibrium {
  std::vector<double> angles;     ///< Per section, about its own hinge [rad].
  std::vector<double> stiffness;  ///< Decrease of the moments with the angles of the floating sections, row by row [N
                                  ///< m/rad].
  std::vector<double> angle_up, angle_down;  ///< Range of each section's angle left by hinge friction [rad].
  Findings findings;
};

/// Equilibrium with its mesh: sufficient to recover results, to start the next case, or to start dynamics.
struct StaticSolution {
  StaticSolution();  // These six are compiled once: copying all members is long, and many sources do it.
  StaticSolution(const StaticSolution&);
  StaticSolution(StaticSolution&&) noexcept;
  StaticSolution& operator=(const StaticSolution&);
  StaticSolution& operator=(StaticSolution&&) noexcept;
  ~StaticSolution();

  LineMesh mesh;
  LineState state;
  SolveReport report;
  std::vector<BendingMemory> bending;     ///< Plastic history per Gauss point; empty if nothing yields.
  std::vector<RollerPush> pushes;         ///< Roller forces, if steel may yield: a line that moves on passes them.
  VesselPose pose;                        ///< Pose of the vessel.
  std::optional<MooringSpread> moorings;  ///< Its mooring lines with their lengths, if any.
  Mat6 station_stiffness = Mat6::Zero();  ///< Stiffness of these about the centre of gravity of a floating hull [N/m,
                                          ///< N, N m].
  std::optional<WinchPlan> winches;       ///< Winch lengths during a pull-ahead.
  std::shared_ptr<const StaticLines> lines;  ///< Lines without a lay (lines_setup.h), if any.
  LoadHistory past;                          ///< Load history used in its solution.
  StingerEquilibrium stinger;                ///< State of a hinged stinger, see statics/stinger/stinger_equilibrium.h.
  std::optional<MeshZones> zones;            ///< Zones for which its mesh was made.
  MeshDescription mesh_asked;                ///< Element lengths requested by the model.

  bool has_pipe() const { return !mesh.length.empty(); }
};

/// Equations of a line on a mesh, with its load history.
StaticSystem system_with_history(const Model& model, LineMesh mesh, const LoadHistory& past);

/// Conclusion from a failure for a search for another tension.
enum class FailureKind {
  other,
  tension_too_low,  ///< The line cannot be suspended or would be in compression at the seabed.
  no_touchdown,     ///< The line ends before it reaches the seabed.
};

/// Reason why there is no solution.
struct StaticFailure {
  std::string what;    ///< One sentence: what failed.
  std::string where;   ///< Place along the line; empty for the whole line.
  std::string why;     ///< Reason, and how to correct it.
  bool input = false;  ///< True if the model requests an unsupported analysis: reported as an error of the model file.
  std::string key{};   ///< Key of the model file concerned; empty if none.
  FailureKind kind = FailureKind::other;
};

struct StaticOutcome {
  std::optional<StaticSolution> solution;
  std::optional<StaticFailure> failure;
};

/// Finds the equilibrium. `start`: solution of a neighbouring case for a warm start, if any (slider, continuation).
StaticOutcome solve_statics(const Model& model, const StaticSolution* start = nullptr, const LoadHistory& past = {});

/// Same from a neighbouring solution only: fails if the warm start does not converge.
StaticOutcome continue_statics(const Model& model, const StaticSolution& start, const LoadHistory& past = {});

}  // namespace overbend
