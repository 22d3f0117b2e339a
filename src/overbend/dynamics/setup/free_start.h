/// The beginning of a run with a hull that floats free.
#pragma once

#include <optional>

#include "hull/hull.h"
#include "statics/solver/statics.h"
#include "system/assembly.h"

namespace overbend {

/// Lets `hull` of `assembly` go at a state in which it was held as drawn: it is ballasted, where the model says so, for
/// draught, heel and trim to stay with pipe and lines on it, and hull, lines and pipe come to rest together, the
/// tensioner keeping its tension. Says why where they do not.
std::optional<StaticFailure> rest_afloat(Assembly& assembly, Ballast ballast, Hull& hull, SystemState& state);

/// Moves the free body of a state at rest by `offset` of its coordinates (m, rad) and holds it there while all lines
/// come to rest again, the tensioner keeping its tension. Says why where they do not.
std::optional<StaticFailure> displace_hull(Assembly& assembly, const Vec6& offset, SystemState& state);

/// Lets a hull go as rest_afloat() does, its mooring lines pulled in over the bed (mooring_lines.h), and moves it by
/// `release`, along and about the axes of the hull as drawn, where that is not zero.
std::optional<StaticFailure> let_hull_go(const System& system, Ballast ballast, Hull& hull, const Vec6& release,
                                         SystemState& state);

}  // namespace overbend
