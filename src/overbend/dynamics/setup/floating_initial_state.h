/// Initial state of a run with a floating hull.
#pragma once

#include <optional>

#include "hull/hull.h"
#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// Releases `hull` of `assembly` from a state in which it was held in its nominal pose: it is ballasted, if the model
/// says so, to keep draught, heel and trim under the loads of pipe and lines, and the coupled equilibrium of hull,
/// lines and pipe is solved at constant tensioner tension. Returns a failure if there is none.
std::optional<StaticFailure> solve_floating_equilibrium(Assembly& assembly, Ballast ballast, Hull& hull,
                                                        SystemState& state);

/// Moves the free body of an equilibrium by `offset` of its coordinates (m, rad) and holds it there while the
/// equilibrium of all lines is solved at constant tensioner tension. Returns a failure if there is none.
std::optional<StaticFailure> offset_hull(Assembly& assembly, const Vec6& offset, SystemState& state);

/// Solves the equilibrium as solve_floating_equilibrium(), with the seabed friction of the mooring lines mobilised
/// (print_moorings.h), and then offsets the hull by `release`, along and about the axes of its nominal pose, if that is
/// not zero.
std::optional<StaticFailure> release_hull(const System& system, Ballast ballast, Hull& hull, const Vec6& release,
                                          SystemState& state);

}  // namespace overbend
