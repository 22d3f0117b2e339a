#include "dynamics/start_leap.h"

#include "dynamics/dynamics.h"
#include "mechanics/sea.h"
#include "mechanics/vessel_motion.h"

namespace overbend {

double leap_at_start(const Model& model) {
  const Description& d = model.description;
  if (d.dynamics->build_up > 0.0 || d.vessel.motion == VesselMotion::coupled) return 0.0;
  const Sea sea = make_sea(d.environment.waves, d.environment.water_depth, 0.0, dynamic_options(model).seed);
  const Vec3 shoe_V(d.vessel.stern_shoe_x, 0.0, d.vessel.stern_shoe_z);
  const Vec3 at_rest = model.mean_pose.p_WV + model.mean_pose.R_WV * shoe_V;
  return (point_motion(vessel_motion(make_vessel_motion(model, sea), 0.0, BuildUp{}), shoe_V).place - at_rest).norm();
}

}  // namespace overbend
