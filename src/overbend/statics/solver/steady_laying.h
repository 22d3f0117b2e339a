/// Steady laying: the pipe on the bed lies on the line on which it was laid, docs/theory/steady-laying.md.
///
/// The vessel lays along its route while a current pushes the pipe aside. In the steady state the shape moves with the
/// vessel: a point of the pipe touches the bed where the shape first does, at an offset c from the route, and stays
/// there. Its friction displacement since then is y - c: the laid line is the route shifted by
///     c = y at first contact.
/// In the state, c is the position of the far end across the route, so it is transferred with every solution.
#pragma once

#include "model/lay_route.h"
#include "statics/solver/continuation.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Line on which the pipe of a solution lies.
LayRoute laid_route(const Model& model, const StaticSolution& solution);

/// Finds the equilibrium of steady laying from one whose pipe lies at any offset c from the route, by Newton's method
/// on c with first-order prediction of the equilibria. Without a side load both are equal and nothing is done. Returns
/// false if it is not found.
bool solve_steady_laying(EquilibriumProblem& problem);

/// On a curved route: offset to port at which the same lay on a straight route would lie [m]. The shape in a bend does
/// not move with the vessel, so the offset follows from the side load alone.
double laid_offset_in_bend(const Model& model);

/// Moves the line on which the pipe lies to `to_port` metres from its route, together with the equilibrium.
bool move_line(EquilibriumProblem& problem, double to_port);

}  // namespace overbend
