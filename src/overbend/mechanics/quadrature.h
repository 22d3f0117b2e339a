/// Integration constants of the rod element on xi in [0, 1].
#pragma once

namespace overbend {

inline constexpr int kGaussPoints = 4;
inline constexpr double kGaussXi[kGaussPoints] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                                  0.93056815579702629};
inline constexpr double kGaussWeight[kGaussPoints] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                                      0.17392742256872693};

/// Integrals of the products of the quadratic Lagrange functions at xi = 0, 1/2, 1, for unit length.
inline constexpr double kStrainMass[3][3] = {{4.0 / 30.0, 2.0 / 30.0, -1.0 / 30.0},
                                             {2.0 / 30.0, 16.0 / 30.0, 2.0 / 30.0},
                                             {-1.0 / 30.0, 2.0 / 30.0, 4.0 / 30.0}};

}  // namespace overbend
