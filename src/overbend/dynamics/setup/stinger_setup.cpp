#include "dynamics/setup/stinger_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/contact_cells.h"
#include "model/pipe/section.h"
#include "model/vessel/stinger_rotation.h"
#include "statics/stinger/stinger_forces.h"

namespace overbend {
namespace {

constexpr double kFrictionDamping = 0.1;  ///< Damping of the elastic part of friction, as a share of critical.

const StingerSectionDescription& described(const Model& model, std::size_t section) {
  return model.description.supports.sections[section];
}

/// Nominal position of a point in a section, in frame V at its static angle.
Vec3 at_rest(const Model& model, std::size_t section, const StingerPoint& drawn, double y = 0.0) {
  return point_in_vessel(model,
                         point_on_section(described(model, section), model.supports.sections[section], drawn, y));
}

/// Inertia of a uniform rod along `axis` with this radius of gyration across it.
Mat3 rod_inertia(double mass, double radius, const Vec3& axis) {
  const Vec3 d = axis.normalized();
  return mass * radius * radius * (Mat3::Identity() - d * d.transpose());
}

/// Adds a part to a rigid body (Steiner).
void add_part(SectionBody& body, double mass, const Vec3& center_V, const Mat3& inertia) {
  if (mass <= 0.0) return;
  const double total = body.mass + mass;
  const Vec3 between = center_V - body.center_V;
  const double reduced = body.mass * mass / total;
  body.inertia_V += inertia + reduced * (between.squaredNorm() * Mat3::Identity() - between * between.transpose());
  body.center_V += mass / total * between;
  body.mass = total;
}

void add_tank(const Model& model, std::size_t section, std::size_t number, SectionBody& body) {
  const StingerTankDescription& tank = described(model, section).tanks[number];
  const Vec3 from = at_rest(model, section, tank.from, tank.y), to = at_rest(model, section, tank.to, tank.y);
  const double length = (to - from).norm();
  const double volume = 0.25 * std::numbers::pi * tank.diameter * tank.diameter * length;
  const double mass = (tank.weight + tank.ballast * volume * model.water_weight_density) / kGravity;
  add_part(body, mass, 0.5 * (from + to), rod_inertia(mass, length / std::sqrt(12.0), to - from));
  const int strips = tank_strips(length);
  for (int i = 0; i < strips; ++i) {
    TankStrip strip;
    strip.from_V = from + static_cast<double>(i) / strips * (to - from);
    strip.to_V = from + static_cast<double>(i + 1) / strips * (to - from);
    strip.diameter = tank.diameter;
    strip.drag = tank.drag;
    strip.added_mass = tank.added_mass;
    strip.tank = static_cast<int>(number);
    body.strips.push_back(strip);
  }
}

void add_structure(const Model& model, std::size_t section, SectionBody& body) {
  const StingerBodyDescription& description = *described(model, section).body;
  const Vec3 reach = section_reach_V(model, section), centre = at_rest(model, section, description.at);
  const double mass = description.weight / kGravity;
  add_part(body, mass, centre,
           rod_inertia(mass, description.radius_of_gyration.value_or(reach.norm() / std::sqrt(12.0)), reach));
  if (description.buoyancy > 0.0 || description.added_mass > 0.0 || description.drag_area > 0.0) {
    ImmersedBody part;
    part.place_V = at_rest(model, section, description.buoyancy_at.value_or(description.at));
    part.across_V = Vec3::UnitY().cross(reach.normalized());
    part.volume = description.buoyancy / model.water_weight_density;
    part.added_mass = description.added_mass;
    part.drag_area = description.drag_area;
    body.immersed = part;
  }
}

SectionSpring make_section_spring(const Model& model, std::size_t section,
                                  const StingerSpringDescription& description) {
  const double drawn =
      std::hypot(description.on_barge.x - description.on_stinger.x, description.on_barge.z - description.on_stinger.z);
  SectionSpring spring;
  spring.vessel_V = point_in_vessel(model, Vec3(description.on_barge.x, 0.0, description.on_barge.z));
  spring.section_V = at_rest(model, section, description.on_stinger);
  spring.stiffness = description.stiffness;
  spring.length = description.stiffness > 0.0 ? drawn - description.pretension / description.stiffness : drawn;
  spring.wire = description.wire;
  return spring;
}

/// Moment of inertia about the hinge, with added mass [kg m2].
double turning_inertia(const SectionBody& body, const Vec3& hinge_V, double density) {
  const auto arm2 = [&](const Vec3& p) { return std::pow(p.x() - hinge_V.x(), 2) + std::pow(p.z() - hinge_V.z(), 2); };
  double sum = body.inertia_V(1, 1) + body.mass * arm2(body.center_V);
  for (const TankStrip& strip : body.strips) {
    const double volume =
        0.25 * std::numbers::pi * strip.diameter * strip.diameter * (strip.to_V - strip.from_V).norm();
    sum += density * strip.added_mass * volume * arm2(0.5 * (strip.from_V + strip.to_V));
  }
  if (body.immersed) {
    sum += body.immersed->added_mass * arm2(body.immersed->place_V);
  }
  return sum;
}

HingeLaw make_hinge_law(const StingerSectionDescription& section, double inertia) {
  HingeLaw law;
  if (section.limits) {
    law.up = section.limits->up;
    law.down = section.limits->down;
    law.stop_stiffness = section.stop_stiffness;
    law.stop_damping = 2.0 * kStopDamping * std::sqrt(section.stop_stiffness * inertia);
  }
  law.friction = section.hinge_friction;
  law.friction_damping = 2.0 * kFrictionDamping * std::sqrt(section.hinge_friction / kBreakawayRotation * inertia);
  return law;
}

/// Sets the rollers of one section, or of none (-1), with their cells.
void put_rollers(const Model& model, const std::vector<BodyRoller>& all, int section, double pipe_radius, Body& body) {
  Supports section_supports = model.supports;
  section_supports.rollers.clear();
  body.rollers.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Roller& roller = model.supports.rollers[i];
    if (model.supports.boxes[static_cast<std::size_t>(roller.box)].section == section) {
      section_supports.rollers.push_back(roller);
      body.rollers.push_back(all[i]);
    }
  }
  body.cells = contact_cells(section_supports, pipe_radius);
}

FreeBody hinged_body(const Model& model, std::size_t section, std::shared_ptr<const SectionSea> sea,
                     double line_weight) {
  constexpr double kShareOfWeight = 1e-3;
  const StingerSectionDescription& description = described(model, section);
  const StingerSection& lies = model.supports.sections[section];
  FreeBody free;
  HingedBody& hinged = free.hinge.emplace();
  hinged.carrier = static_cast<int>(section);  // the vessel is body 0
  hinged.section = section_body(model, section);
  hinged.hinge.place_V = point_in_vessel(model, lies.hinge_S);
  hinged.hinge.rest = lies.angle;
  const double inertia = turning_inertia(hinged.section, hinged.hinge.place_V, model.water_density);
  hinged.law = make_hinge_law(description, inertia);
  hinged.held = description.angle.has_value() || !description.floats();
  hinged.sea = std::move(sea);
  free.arm = section_reach_V(model, section).norm();
  free.force_scale = std::max(line_weight, kShareOfWeight * hinged.section.mass * kGravity);
  free.inertia(kHingeFreedom) = std::max(inertia, 1.0);
  free.rest.h(kHingeFreedom) = lies.angle;
  return free;
}

}  // namespace

bool stinger_floats(const Model& model) {
  const std::vector<StingerSectionDescription>& sections = model.description.supports.sections;
  return std::any_of(sections.begin(), sections.end(),
                     [](const StingerSectionDescription& s) { return s.floats() && !s.angle; });
}

SectionBody section_body(const Model& model, std::size_t section) {
  const StingerSectionDescription& description = described(model, section);
  SectionBody body;
  if (description.body) {
    add_structure(model, section, body);
  }
  for (std::size_t i = 0; i < description.tanks.size(); ++i) {
    add_tank(model, section, i, body);
  }
  for (const StingerSpringDescription& spring : description.springs) {
    body.springs.push_back(make_section_spring(model, section, spring));
  }
  return body;
}

void add_hinged_stinger(const Model& model, const Sea& sea, double build_up, System& system) {
  if (!stinger_floats(model)) {
    return;
  }
  const Line& pipe_line = system.lines[find_laid_pipe(system).value().line];
  const LineElements& pipe = pipe_line.elements;
  const double pipe_radius = *std::max_element(pipe.radius.begin(), pipe.radius.begin() + pipe.count);
  const auto water =
      std::make_shared<const SectionSea>(SectionSea{sea, model.current, build_up, model.water_weight_density});
  const std::vector<BodyRoller> all = system.bodies[kVessel].rollers;
  put_rollers(model, all, -1, pipe_radius, system.bodies[kVessel]);
  for (std::size_t i = 0; i < model.supports.sections.size(); ++i) {
    Body body;
    body.ramp_origin_V = system.bodies[kVessel].ramp_origin_V;
    put_rollers(model, all, static_cast<int>(i), pipe_radius, body);
    body.free = hinged_body(model, i, water, pipe_line.force_scale);
    system.bodies.push_back(std::move(body));
  }
}

void preload_hinge_stops(Assembly& assembly, const SystemState& state, System& system) {
  constexpr double kAtStop = 1e-6;  // maximum distance of a loaded stop from the static angle [rad]
  if (assembly.hinged().empty()) {
    return;
  }
  SystemState evaluated = state;
  assembly.impose_ends(evaluated);
  assembly.evaluate(evaluated, state, {}, false);
  const std::vector<int> free = free_bodies(system);
  for (std::size_t k = 0; k < free.size(); ++k) {
    std::optional<HingedBody>& hinged = system.bodies[static_cast<std::size_t>(free[k])].free->hinge;
    if (!hinged || hinged->held || hinged->law.stop_stiffness <= 0.0) continue;
    HingeLaw& law = hinged->law;
    const double angle = hinged->hinge.rest;
    const double moment = -assembly.body_residual()[6 * k + kHingeFreedom];  // of everything but the stop, tip down
    if (moment > 0.0 && std::abs(angle - law.down) < kAtStop) {
      law.down = angle - moment / law.stop_stiffness;
    } else if (moment < 0.0 && std::abs(angle - law.up) < kAtStop) {
      law.up = angle - moment / law.stop_stiffness;
    }
  }
}

}  // namespace overbend
