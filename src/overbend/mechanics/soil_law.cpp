#include "mechanics/soil_law.h"

#include "mechanics/line_kernel.h"

namespace overbend {

double soil_force(const LineEnvironment& env, double penetration) {
  const double elastic = env.bed_stiffness * penetration;
  if (env.bed_soil == kHyperbolicSoil) return elastic / (1.0 + elastic / env.bed_bearing);
  if (env.bed_soil == kBilinearSoil && elastic > env.bed_bearing) {
    return env.bed_bearing + kSoftSoil * (elastic - env.bed_bearing);
  }
  return elastic;
}

}  // namespace overbend
