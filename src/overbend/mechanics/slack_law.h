/// Axial law of what only pulls: chains, ropes, wires. Numbers alone: the element kernel reads them.
///
///     N = EA (share f(e) + (1 - share) p(e + time e')),    p(e) = 0                e <= -d
///                                                                 (e + d)^2/(4 d)
///                                                                 e                e >= d
///
/// with f(e) = ((1 + e) - (1 + e)^-3)/4, which is e where that is small, and without bounds where an element shrinks to
/// nothing. For pipes N = EA e. The transition is in strain and the same for elements of all lengths. Strain that comes
/// and goes costs energy, and none of it is pushed.
#pragma once

namespace overbend {

inline constexpr double kSlackStrain = 1e-5;  ///< d [-]
/// Share of EA that what only pulls keeps in compression, so that a slack line has some stiffness along itself: 6 N in
/// a chain of 5e8 N that is pushed together by a tenth of its length [-].
inline constexpr double kSlackShare = 1e-7;

/// Internal damping of what only pulls, of critical in the first axial mode of the line: the pull that goes through a
/// line when it snaps tight is else thrown to and fro without end [-].
inline constexpr double kSlackDamping = 0.01;

/// Simpson's weights of the strains at xi = 0, 1/2, 1. Each is a spring of its own there: products of strains at two
/// points, of which one pulls and the other is slack, would be no energy of either.
inline constexpr double kSlackWeight[3] = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};

}  // namespace overbend
