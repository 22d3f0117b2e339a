/// Axial law of tension-only elements: chains, ropes, wires. Constants only, as the element kernel reads them.
///
///     N = EA (share f(e) + (1 - share) p(e + time e')),    p(e) = 0                e <= -d
///                                                                 (e + d)^2/(4 d)
///                                                                 e                e >= d
///
/// with f(e) = ((1 + e) - (1 + e)^-3)/4, which is e where that is small, and unbounded where an element shrinks to zero
/// length. For pipes N = EA e. The transition is in strain and the same for elements of all lengths. Damping dissipates
/// energy of varying strain and causes no compression.
#pragma once

namespace overbend {

inline constexpr double kSlackStrain = 1e-5;  ///< d [-]
/// Fraction of EA that tension-only elements keep in compression, so that a slack line has some axial stiffness: 6 N in
/// a chain of 5e8 N compressed by a tenth of its length [-].
inline constexpr double kSlackShare = 1e-7;

/// Internal damping of tension-only elements, fraction of critical in the first axial mode of the line: without it the
/// tension wave of a snap load would be reflected without end [-].
inline constexpr double kSlackDamping = 0.01;

/// Simpson's weights of the strains at xi = 0, 1/2, 1. Each point is a separate spring: a product of strains at two
/// points, one in tension and one slack, would not derive from an energy of either.
inline constexpr double kSlackWeight[3] = {1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0};

}  // namespace overbend
