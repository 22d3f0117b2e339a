#include "system/vessel_body.h"

#include <algorithm>
#include <cmath>

#include "mechanics/impact_mass.h"
#include "mechanics/restitution.h"

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

/// Damping ratio of a roller; consecutive rollers of one kind share the search for it.
class DampingRatios {
 public:
  double of(const Roller& roller) {
    if (!(roller.restitution == restitution_) || roller.damping != damping_) {
      restitution_ = roller.restitution;
      damping_ = roller.damping;
      ratio_ = damping_ratio(restitution_, restitution_form(damping_));
    }
    return ratio_;
  }

 private:
  double restitution_ = -1.0, ratio_ = 0.0;  // no roller has that restitution
  RollerDamping damping_ = RollerDamping::textbook;
};

ContactLaw make_contact_law(const Roller& roller, double stiffness, double mass, double zeta) {
  ContactLaw law;
  law.stiffness = stiffness;
  law.damping = 2.0 * zeta * std::sqrt(mass * law.stiffness);
  law.tangential_stiffness =
      roller.tangential_stiffness > 0.0 ? roller.tangential_stiffness : kTangentialStiffnessRatio * stiffness;
  law.tangential_damping = 2.0 * zeta * std::sqrt(mass * law.tangential_stiffness);
  law.friction_axial = roller.friction_axial;
  law.friction_lateral = roller.friction_lateral;
  return law;
}

}  // namespace

double penalty_stiffness(const Section& pipe) {
  return pipe.EI / std::pow(pipe.steel_diameter, 3);
}

std::vector<BodyRoller> vessel_rollers(const Model& model) {
  const VesselPose& mean = model.mean_pose;
  const auto to_V = [&](const Vec3& d_W) { return Vec3(mean.R_WV.transpose() * d_W); };
  std::vector<BodyRoller> rollers;
  DampingRatios ratios;
  for (const Roller& roller : model.supports.rollers) {
    const Section& pipe = model.pipe_over(roller);
    const Vec3 center = point_from_ramp(model, mean, roller.center_S);
    const double stiffness = roller.stiffness > 0.0 ? roller.stiffness : penalty_stiffness(pipe);
    BodyRoller of_body;
    of_body.center_V = to_V(center - mean.p_WV);
    of_body.axis_V = to_V(direction_from_ramp(mean, roller.axis_S));
    of_body.normal_V = to_V(direction_from_ramp(mean, roller.normal_S));
    of_body.half_face = 0.5 * roller.face;
    of_body.radius = roller.radius;
    of_body.box = roller.box;
    of_body.position = roller.position;
    of_body.mass = impact_mass(moved_mass(model, pipe, center), pipe.EI, stiffness);
    of_body.law = make_contact_law(roller, stiffness, of_body.mass, ratios.of(roller));
    rollers.push_back(of_body);
  }
  return rollers;
}

Body vessel_body(const Model& model, double pipe_radius) {
  Body body;
  body.rollers = vessel_rollers(model);
  body.cells = contact_cells(model.supports, pipe_radius);
  body.ramp_origin_V = Vec3(model.description.vessel.stern_shoe_x, 0.0, model.description.vessel.stern_shoe_z);
  return body;
}

MobilisedFriction static_rub(const Model& model) {
  const RollerFriction friction = model.description.statics.roller_friction;
  return {friction == RollerFriction::none ? 0.0 : friction == RollerFriction::lay ? 1.0 : -1.0, 0.0};
}

RigidMotion resting(const VesselPose& pose) {
  RigidMotion motion;
  motion.pose = pose;
  return motion;
}

}  // namespace overbend
