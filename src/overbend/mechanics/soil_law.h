/// Soil that is not linear: force per length of the bed by penetration. Raw numbers; line_kernel_ground.h has the same
/// for a batch.
#pragma once

namespace overbend {

struct LineEnvironment;

/// LineEnvironment::bed_soil where it is not linear, and the second stiffness of bilinear soil over the first.
inline constexpr int kHyperbolicSoil = 1, kBilinearSoil = 2;
inline constexpr double kSoftSoil = 0.1;

/// Force of the bed per length at a penetration [m], normal to it [N/m]. Linear: k x. Hyperbolic (Kondner 1963):
/// k x / (1 + k x / bearing). Bilinear: a tenth of the stiffness beyond the bearing force. Soil follows its curve both
/// ways.
double soil_force(const LineEnvironment& env, double penetration);

}  // namespace overbend
