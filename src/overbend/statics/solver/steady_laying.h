/// Steady laying: the pipe on the bed lies on the line on which it was laid, docs/theory/steady-laying.md.
///
/// The barge lays along its route while a current pushes the pipe aside. Steadily, the shape goes with the barge: a
/// point of the pipe touches the bed where the shape first does, to one side of the route by c, and stays there. Its
/// friction has been stretched since by y - c: the laid line is the route shifted by
///     c = y at first contact.
/// In the state c is the place of the far end across the route, so it travels with every solution.
#pragma once

#include "model/lay_route.h"
#include "statics/solver/static_ways.h"
#include "statics/solver/statics.h"

namespace overbend {

/// The line on which the pipe of a solution lies.
LayRoute laid_route(const Model& model, const StaticSolution& solution);

/// From an equilibrium whose pipe lies beside the route by any c to the one of steady laying, by Newton's method on c
/// with the equilibria followed to first order. Without a side load it is the same and nothing is done. False where it
/// is not found.
bool settle_steadily(StaticCase& at);

/// On a route that bends: how far to port of it the same lay on a straight route would lie [m]. The shape of a bend
/// does not go along with the barge, so the side load alone says where the pipe is laid.
double laid_beside(const Model& model);

/// Moves the line on which the pipe lies to `to_port` metres beside its route, the equilibrium along with it.
bool move_line(StaticCase& at, double to_port);

}  // namespace overbend
