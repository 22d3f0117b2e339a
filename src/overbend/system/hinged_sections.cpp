#include "system/hinged_sections.h"

#include <algorithm>

namespace overbend {
namespace {

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

int hinge_unknown(int number) {
  return 6 * number + kHingeFreedom;
}

}  // namespace

HingedSections::HingedSections(const System& system, const std::vector<int>& numbers) : system_(&system) {
  const int free = static_cast<int>(std::count_if(numbers.begin(), numbers.end(), [](int n) { return n >= 0; }));
  at_.assign(to_size(free), -1);
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    if (!system.bodies[i].free || !system.bodies[i].free->hinge) {
      continue;
    }
    const HingedBody& body = *system.bodies[i].free->hinge;
    Section section;
    section.body = &body;
    section.index = static_cast<int>(i);
    section.number = numbers[i];
    const int carrier = numbers[to_size(body.carrier)];
    if (carrier >= 0 && at_[to_size(carrier)] >= 0) {
      section.chain = this->section(carrier).chain;
    }
    section.chain.push_back(section.number);
    section.points.resize(water_places(body.section));
    section.water.resize(section.points.size());
    at_[to_size(section.number)] = static_cast<int>(sections_.size());
    sections_.push_back(std::move(section));
  }
  if (sections_.empty()) {
    return;
  }
  vessel_ = numbers[to_size(sections_.front().body->carrier)];
  now_.turns.resize(sections_.size());
  more_ = less_ = now_;
  high_.assign(to_size(6 * free), 0.0);
  low_ = high_;
  tangent_.assign(high_.size() * high_.size(), 0.0);
}

std::span<const int> HingedSections::chain(int number) const {
  return section(number).chain;
}

/// Sections come after those that carry them.
void HingedSections::move(const Coordinates& to) {
  if (vessel_ >= 0) {
    const FreeBody& vessel = *system_->bodies[to_size(sections_.front().body->carrier)].free;
    barge_ = rigid_motion(make_body_motion(to.h, to.v, to.a), vessel.reference_V, vessel.origin);
    vessel_pose_ = make_pose(to.h);
  }
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    Section& section = sections_[i];
    const RigidMotion& carrier =
        section.chain.size() > 1 ? this->section(section.chain[section.chain.size() - 2]).motion : barge_;
    const Hinge& hinge = section.body->hinge;
    section.turn = to.turns[i];
    section.motion = hinged_motion(carrier, hinge, to.turns[i]);
    section.twist = {carrier.pose.R_WV * hinge.axis_V, carrier.pose.p_WV + carrier.pose.R_WV * hinge.place_V};
  }
}

void HingedSections::lead(const std::vector<HullState>& states, Surroundings& surroundings) {
  barge_ = surroundings.bodies[to_size(sections_.front().body->carrier)];
  if (vessel_ >= 0) {
    const HullState& vessel = states[to_size(vessel_)];
    now_.h = vessel.h;
    now_.v = vessel.v;
    now_.a = vessel.acc;
  }
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const HullState& section_state = states[to_size(sections_[i].number)];
    now_.turns[i] = {section_state.h(kHingeFreedom), section_state.v(kHingeFreedom), section_state.acc(kHingeFreedom)};
  }
  move(now_);
  for (const Section& section : sections_) {
    surroundings.bodies[to_size(section.index)] = section.motion;
  }
}

void HingedSections::evaluate_water(double time) {
  for (Section& section : sections_) {
    water_at_section(*section.body->sea, time, section.body->section, section.motion, section.points, section.water);
  }
}

/// Adds the generalised forces of all sections at their positions set by move().
void HingedSections::add_forces(std::vector<double>& sum) {
  for (Section& section : sections_) {
    const HingedBody& body = *section.body;
    const Vec3& about = section.twist.origin;
    const Wrench wrench =
        section_residual(body.section, section.motion, barge_, section.water, body.sea->weight_density, about);
    section.unbalance = wrench;
    for (const int number : section.chain) {
      const Twist& twist = this->section(number).twist;
      sum[to_size(hinge_unknown(number))] +=
          twist.axis.dot(wrench.moment) + twist.generalised_force(wrench.force, about);
    }
    if (vessel_ >= 0) {
      const Wrench on_barge = springs_on_barge(body.section, section.motion, barge_, about);
      Eigen::Map<Vec6>(sum.data() + 6 * vessel_) +=
          generalised_force(vessel_pose_, about - vessel_pose_.place, wrench.force - on_barge.force) +
          generalised_moment(vessel_pose_, wrench.moment - on_barge.moment);
    }
  }
}

void HingedSections::add_joints(std::vector<HullState>& state, const std::vector<HullState>& before,
                                const Weights& weights, bool with_tangent, std::vector<double>& residual) {
  for (Section& section : sections_) {
    const std::size_t number = to_size(section.number), unknown = to_size(hinge_unknown(section.number));
    section.moment =
        hinge_moment(section.body->law, section.turn.angle, section.turn.rate, before[number].hinge_slip, weights.step);
    state[number].hinge_slip = section.moment.slip;
    residual[unknown] -= section.moment.sum();
    if (with_tangent) {
      tangent_[unknown * high_.size() + unknown] -= section.moment.by_angle + weights.velocity * section.moment.by_rate;
    }
  }
}

void HingedSections::evaluate(std::vector<HullState>& state, const std::vector<HullState>& before,
                              const Weights& weights, bool with_tangent, std::vector<double>& residual) {
  if (with_tangent) {
    find_tangent(weights);
    move(now_);
  }
  add_forces(residual);
  add_joints(state, before, weights, with_tangent, residual);
}

/// Central difference; forces are linear in the accelerations, for which it is exact.
void HingedSections::add_column(int unknown, double weight, const Coordinates& more, const Coordinates& less,
                                double change) {
  std::fill(high_.begin(), high_.end(), 0.0);
  std::fill(low_.begin(), low_.end(), 0.0);
  move(more);
  add_forces(high_);
  move(less);
  add_forces(low_);
  for (std::size_t i = 0; i < high_.size(); ++i) {
    tangent_[i * high_.size() + to_size(unknown)] += weight * (high_[i] - low_[i]) / (2.0 * change);
  }
}

void HingedSections::find_tangent(const Weights& weights) {
  constexpr double kAngle = 1e-6, kRate = 1e-4, kShift = 1e-4;  // [rad], [rad/s], [m]
  std::fill(tangent_.begin(), tangent_.end(), 0.0);
  const auto differ = [&](int unknown, double weight, double change, auto value) {
    if (weight == 0.0) return;
    more_ = now_;  // same sizes: no allocation
    less_ = now_;
    value(more_) += change;
    value(less_) -= change;
    add_column(unknown, weight, more_, less_, change);
  };
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const int unknown = hinge_unknown(sections_[i].number);
    differ(unknown, 1.0, kAngle, [i](Coordinates& c) -> double& { return c.turns[i].angle; });
    differ(unknown, weights.velocity, kRate, [i](Coordinates& c) -> double& { return c.turns[i].rate; });
    differ(unknown, weights.acceleration, 1.0, [i](Coordinates& c) -> double& { return c.turns[i].acceleration; });
  }
  for (Eigen::Index k = 0; k < (vessel_ >= 0 ? 6 : 0); ++k) {
    const int unknown = 6 * vessel_ + static_cast<int>(k);
    differ(unknown, 1.0, k < 3 ? kShift : kAngle, [k](Coordinates& c) -> double& { return c.h(k); });
    differ(unknown, weights.velocity, kRate, [k](Coordinates& c) -> double& { return c.v(k); });
    differ(unknown, weights.acceleration, 1.0, [k](Coordinates& c) -> double& { return c.a(k); });
  }
}

void HingedSections::add_roller(int number, const Vec3& point, const Vec3& force, std::vector<double>& residual) {
  Section& touched = section(number);
  touched.unbalance.force += force;
  touched.unbalance.moment += (point - touched.twist.origin).cross(force);
  for (const int carried : touched.chain) {
    residual[to_size(hinge_unknown(carried))] += twist(carried).generalised_force(force, point);
  }
  if (vessel_ >= 0) {
    Eigen::Map<Vec6>(residual.data() + 6 * vessel_) +=
        generalised_force(vessel_pose_, point - vessel_pose_.place, force);
  }
}

/// Required support force and moment of a section and all that it carries, about its hinge.
Wrench HingedSections::carried(std::size_t first) const {
  Wrench sum;
  const Section& first_section = sections_[first];
  for (const Section& member : sections_) {
    if (std::find(member.chain.begin(), member.chain.end(), first_section.number) == member.chain.end()) continue;
    sum.force += member.unbalance.force;
    sum.moment +=
        member.unbalance.moment + (member.twist.origin - first_section.twist.origin).cross(member.unbalance.force);
  }
  return sum;
}

/// The vessel does work at the hinges that it carries and at the ends of the springs. For a free vessel this is
/// internal. The moment about a hinge axis beyond stops and friction is the vessel's if it holds the angle.
BodyEnergy HingedSections::energy() const {
  BodyEnergy sum;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const Section& section = sections_[i];
    const SectionEnergy part =
        section_energy(section.body->section, section.motion, barge_, section.water, section.body->sea->weight_density);
    sum.kinetic += part.kinetic;
    sum.stored += part.stored + section.moment.stored;
    sum.power += part.power;
    // Dissipated in the hinge: by stops in excess of their springs, and by friction.
    const double spring_power = stop_spring_moment(section.body->law, section.turn.angle) * section.turn.rate;
    sum.power += section.moment.sum() * section.turn.rate - spring_power;
    if (vessel_ < 0) {
      sum.power += part.barge_power;
      if (section.chain.size() == 1) {
        const Wrench held = carried(i);
        const Vec3 carrier_velocity =
            section.motion.velocity + section.motion.omega.cross(section.twist.origin - section.motion.pose.p_WV);
        sum.power += held.force.dot(carrier_velocity) + held.moment.dot(barge_.omega);
      }
    }
  }
  return sum;
}

HingeReading HingedSections::reading(std::size_t index) const {
  const Section& section = sections_[index];
  const Wrench held = carried(index);
  HingeReading reading;
  reading.angle = section.turn.angle;
  reading.rate = section.turn.rate;
  reading.force = held.force;
  reading.moment = held.moment;
  reading.place = section.twist.origin;
  reading.stop_moment = section.moment.stop;
  reading.friction_moment = section.moment.friction;
  reading.draught = section_draught(section.body->section, section.motion, section.water);
  return reading;
}

}  // namespace overbend
