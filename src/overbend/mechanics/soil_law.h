/// Nonlinear soil: force of the seabed per length by penetration. Scalar form; line_kernel_ground.h has the same for a
/// batch.
#pragma once

namespace overbend {

struct LineEnvironment;

/// LineEnvironment::bed_soil for nonlinear soil, and the ratio of the second to the first stiffness of bilinear soil.
inline constexpr int kHyperbolicSoil = 1, kBilinearSoil = 2;
inline constexpr double kSoftSoil = 0.1;

/// Returns the force of the seabed per length at a penetration [m], normal to it [N/m]. Linear: k x. Hyperbolic
/// (Kondner 1963): k x / (1 + k x / bearing). Bilinear: a tenth of the stiffness beyond the bearing force. Loading and
/// unloading follow the same curve.
double soil_force(const LineEnvironment& env, double penetration);

}  // namespace overbend
