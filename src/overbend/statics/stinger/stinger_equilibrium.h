/// Equilibrium of a hinged stinger and the pipe on it: the moment of roller forces, weight, buoyancy and springs about
/// each hinge, on all sections that turn about it, is zero or carried by a stop.
#pragma once

#include "statics/solver/statics.h"
#include "statics/stinger/stinger_forces.h"

namespace overbend {

/// Maximum angle of a floating section from its nominal angle if no stop limits it [rad].
inline constexpr double kMaxStingerAngle = 60.0 * 3.14159265358979323846 / 180.0;

/// Returns the sections whose angle follows from the forces.
std::vector<std::size_t> floating_sections(const SupportsDescription& supports);

/// Returns the roller forces of the pipe on each section of the stinger, frame W. `system` is evaluated at the
/// equilibrium.
std::vector<std::vector<PointForce>> pipe_on_sections(const StaticSystem& system);

/// Returns the moment about the hinge of each section of all forces on it and on the sections behind it, positive tip
/// down [N m]; without the pipe if `pipe` is empty.
std::vector<double> hinge_moments(const Model& model, const std::vector<std::vector<PointForce>>& pipe);

/// Finds the equilibrium of pipe and stinger, and turns `model.supports` to it; same as solve_statics if no section
/// floats. Quasi-Newton on the moments (BFGS, Nocedal and Wright 2006, 6.1), which are the downward slope of an energy:
/// each step is as long as the moment along it requires, so that the equilibrium is stable and the one reached from the
/// nominal angles. `start` and `past` as for solve_statics.
StaticOutcome solve_with_stinger(Model& model, const StaticSolution* start, const LoadHistory& past);

/// Adds to the solution the stiffness of the stinger, the range left by hinge friction, and findings on other
/// equilibria. `model` has the angles of the solution.
void measure_stinger(const Model& model, StaticSolution& solution);

}  // namespace overbend
