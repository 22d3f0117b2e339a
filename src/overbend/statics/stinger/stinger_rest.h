/// A stinger on hinges and the pipe on it come to rest: the moment about each hinge of roller forces, weight, buoyancy
/// and springs on all that turns about it is zero, or a stop carries the rest.
#pragma once

#include "statics/solver/statics.h"
#include "statics/stinger/stinger_forces.h"

namespace overbend {

/// How far a floating section is followed from where it is drawn, where no stop ends its way [rad].
inline constexpr double kFurthestTurn = 60.0 * 3.14159265358979323846 / 180.0;

/// Sections whose angle the forces decide.
std::vector<std::size_t> floating_sections(const SupportsDescription& supports);

/// What the pipe does to each section of the stinger on its rollers, frame W. `system` is evaluated at the equilibrium.
std::vector<std::vector<PointForce>> pipe_on_sections(const StaticSystem& system);

/// Moment about the hinge of each section of all that acts on it and on those behind it, positive when it turns the
/// tip down [N m]; without the pipe where `pipe` is empty.
std::vector<double> hinge_moments(const Model& model, const std::vector<std::vector<PointForce>>& pipe);

/// Finds the equilibrium of pipe and stinger, and turns `model.supports` to it: as solve_statics where no section
/// floats. Quasi-Newton on the moments (BFGS, Nocedal and Wright 2006, 6.1), which are the downward slope of an energy:
/// a step is as long as the moment along it demands, so that what is found is stable, and the rest that is reached
/// from where it is drawn. `start` and `past` as for solve_statics.
StaticOutcome rest_with_stinger(Model& model, const StaticSolution* start, const LinePast& past);

/// Puts into the solution how stiff the stinger rests, where friction of its hinges may leave it, and what is to be
/// said of other equilibria. `model` lies as it was found.
void measure_stinger(const Model& model, StaticSolution& solution);

}  // namespace overbend
