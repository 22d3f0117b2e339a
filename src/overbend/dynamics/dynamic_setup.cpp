#include "dynamics/dynamic_setup.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mechanics/impact_mass.h"
#include "mechanics/quadrature.h"

namespace overbend {
namespace {

RestitutionForm restitution_form(RollerDamping damping) {
  return damping == RollerDamping::textbook ? RestitutionForm::textbook : RestitutionForm::clipped;
}

/// Effective mass per length of the pipe at a roller [kg/m].
double moved_mass(const Model& model, const Section& pipe, const Vec3& roller_W) {
  const double added = pipe.added_mass_normal * model.water_density * pipe.external_area;
  return pipe.mass() + (roller_W.z() < 0.0 ? added : 0.0);
}

/// Weight in air without the laid tail that is carried on behind the static line [N]: how well forces are balanced does
/// not hang on its length.
double weight_from_static_end(const DynamicLine& line) {
  double weight = 0.0;
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    if (line.mesh.s[e] >= 0.0) weight += line.elements.weight[e] * line.mesh.length[e];
  }
  return weight;
}

/// Stretch of the bed's friction at a point that statics holds with these forces: across the route, along it.
struct StaticStretch {
  double across, along;
};

StaticStretch static_stretch(const LineEnvironment& env, const Vec3& r, double radius, double submerged_weight) {
  const Vec3 normal(env.bed_normal[0], env.bed_normal[1], env.bed_normal[2]);
  const double force = env.bed_stiffness * std::max(0.0, radius - (normal.dot(r) - env.bed_offset));
  if (force <= 0.0 || env.bed_stick <= 0.0) {
    return {0.0, 0.0};
  }
  const Vec3 across(env.route_normal[0], env.route_normal[1], env.route_normal[2]);
  const double off = across.dot(r) - env.route_offset;
  const double limit_across = env.bed_friction_lateral * force / env.bed_stick;
  const double limit_along = env.bed_friction_axial * force / env.bed_stick;
  const double pull = submerged_weight * env.bed_along[2] / env.bed_stick;
  return {std::clamp(off, -limit_across, limit_across), -std::clamp(pull, -limit_along, limit_along)};
}

}  // namespace

std::vector<MovingRoller> moving_rollers(const Model& model, const std::vector<PlacedRoller>& placed) {
  const VesselPose& mean = model.mean_pose;
  const auto to_V = [&](const Vec3& d_W) { return Vec3(mean.R_WV.transpose() * d_W); };
  std::vector<MovingRoller> rollers;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const Roller& roller = model.supports.rollers[i];
    MovingRoller moving;
    moving.center_V = to_V(placed[i].center - mean.p_WV);
    moving.axis_V = to_V(placed[i].axis);
    moving.normal_V = to_V(placed[i].normal);
    moving.half_face = placed[i].half_face;
    moving.radius = placed[i].radius;
    moving.box = roller.box;
    const Section& pipe = model.section_over(roller);
    const double mass = impact_mass(moved_mass(model, pipe, placed[i].center), pipe.EI, placed[i].stiffness);
    const double zeta = damping_ratio(roller.restitution, restitution_form(roller.damping));
    ContactLaw& law = moving.law;
    law.stiffness = placed[i].stiffness;
    law.damping = 2.0 * zeta * std::sqrt(mass * law.stiffness);
    law.tangential_stiffness =
        roller.tangential_stiffness > 0.0 ? roller.tangential_stiffness : kTangentialShare * law.stiffness;
    law.tangential_damping = 2.0 * zeta * std::sqrt(mass * law.tangential_stiffness);
    law.friction_axial = roller.friction_axial;
    law.friction_lateral = roller.friction_lateral;
    moving.mass = mass;
    rollers.push_back(moving);
  }
  return rollers;
}

TensionerLaw tensioner_law(const TensionerDescription& tensioner, double static_tension) {
  constexpr double kToSpeed = 0.5;      // [s]
  constexpr double kResolution = 1e-5;  // of the tension wanted; ten times what a step may leave out of balance
  TensionerLaw law;
  const bool can_move = tensioner.velocity > 0.0 || tensioner.mode == TensionerMode::constant;
  law.mode = can_move ? tensioner.mode : TensionerMode::locked;
  law.wanted = tensioner.tension.value_or(static_tension);
  law.low = tensioner.range_low.value_or(0.0);
  law.high = tensioner.range_high.value_or(0.0);
  law.delay = tensioner.delay;
  law.velocity = tensioner.velocity;
  law.acceleration = tensioner.acceleration.value_or(tensioner.velocity / kToSpeed);
  law.limit = tensioner.travel.value_or(std::numeric_limits<double>::infinity());
  law.resolution = kResolution * law.wanted;
  return law;
}

DynamicLine dynamic_line(const Model& model, const StaticSolution& solution) {
  const LineSystem system(model, model.mean_pose, solution.mesh);
  DynamicLine line;
  line.mesh = solution.mesh;
  line.elements = system.elements();
  line.environment = system.environment();
  line.yielding = system.yielding();
  choose_levels(line.yielding, solution.state.q.data());
  line.anchor = {true, true};
  line.top = {true, model.description.tensioner.guide == Guide::clamped};
  line.rollers = moving_rollers(model, system.rollers());
  double radius = 0.0;
  for (int e = 0; e < line.elements.count; ++e) {
    radius = std::max(radius, line.elements.radius[static_cast<std::size_t>(e)]);
  }
  line.cells = contact_cells(model.supports, radius);
  line.shoe_V = Vec3(model.description.vessel.stern_shoe_x, 0.0, model.description.vessel.stern_shoe_z);
  line.force_scale = weight_from_static_end(line);
  return line;
}

DynamicState static_state(const DynamicLine& line, const StaticSolution& solution, double time) {
  DynamicState state = state_at_rest(line, solution.state.q, time);
  if (!solution.bending.empty()) {
    state.bending = solution.bending;
  }
  const std::size_t padded = line.elements.padded();
  for (int e = 0; e < line.elements.count; ++e) {
    const std::size_t i = static_cast<std::size_t>(e);
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    for (int point = 0; point < kGaussPoints; ++point) {
      const Vec3 r = centreline(q, kGaussXi[point], line.mesh.length[i]).r;
      const StaticStretch stretch = static_stretch(line.environment, r, line.elements.radius[i],
                                                   line.elements.weight[i] - line.elements.buoyancy[i]);
      const std::size_t at = static_cast<std::size_t>(point * kBedDirections) * padded + i;
      state.bed_slip[at] = stretch.across;
      state.bed_slip[at + padded] = stretch.along;
    }
  }
  return state;
}

}  // namespace overbend
