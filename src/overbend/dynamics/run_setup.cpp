#include "dynamics/run_setup.h"

#include <cmath>

#include "dynamics/water_field.h"

namespace overbend {

TensionerPlace tensioner_place(const Model& model, const StaticSolution& start) {
  const TensionerDescription& t = model.description.tensioner;
  const VesselDescription& v = model.description.vessel;
  // The ramp's X runs astern, its Z up; the pipe's tangent points from the anchor to the tensioner.
  const Vec3 place(v.stern_shoe_x - t.x, 0.0, v.stern_shoe_z + t.z);
  if (t.guide == Guide::pinned) {
    const Vec3 tangent(Eigen::Map<const Vec3>(start.state.q.data() + start.state.q.size() - 3));
    return {place, model.mean_pose.R_WV.transpose() * tangent.normalized()};
  }
  return {place, Vec3(std::cos(t.incline), 0.0, std::sin(t.incline))};
}

EndMotion anchor_motion(const StaticSolution& start) {
  const std::vector<double>& q = start.state.q;
  EndMotion motion;
  motion.place = Vec3(q[0], q[1], q[2]);
  motion.direction = Vec3(q[3], q[4], q[5]).normalized();
  return motion;
}

RunSetup make_setup(const Model& model, const StaticSolution& start, double static_tension,
                    const DynamicOptions& options) {
  RunSetup setup;
  const Description& d = model.description;
  setup.sea =
      make_sea(d.environment.waves, d.environment.water_depth, options.build_up + options.duration, options.seed);
  setup.motion = make_vessel_motion(model, setup.sea);
  setup.line = dynamic_line(model, start);
  setup.line.build_up = options.build_up;
  setup.line.tensioner = tensioner_law(d.tensioner, static_tension);
  setup.interval = water_interval(setup.sea, options.output_step);
  return setup;
}

}  // namespace overbend
