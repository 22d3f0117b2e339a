// Energies and powers of an assembly.
#include "system/assembly.h"

#include <algorithm>

namespace overbend {
namespace {

/// Loss of a damped contact, which may be released while its spring is still compressed [W].
double normal_loss(const ContactLaw& law, const RollerContact& contact) {
  if (contact.penetration <= 0.0) {
    return 0.0;
  }
  return (contact.normal - law.stiffness * contact.penetration) * contact.rate;
}

void add(LineEnergy& sum, const LineEnergy& term) {
  sum.kinetic += term.kinetic;
  sum.strain += term.strain;
  sum.gravity += term.gravity;
  sum.seabed += term.seabed;
  sum.fluid_power += term.fluid_power;
  sum.seabed_loss += term.seabed_loss;
  sum.line_loss += term.line_loss;
}

void add_contact_energy(const RollerContacts& rollers, InstantEnergy& sums) {
  for (int i = 0; i < rollers.count(); ++i) {
    const RollerContact& contact = rollers.contacts()[static_cast<std::size_t>(i)];
    const ContactLaw& law = rollers.roller(i).law;
    if (contact.penetration > 0.0) {
      sums.contact += 0.5 * law.stiffness * contact.penetration * contact.penetration;
      sums.contact_loss += normal_loss(law, contact);
      sums.roller_power += contact.force().dot(contact.roller_velocity);
      sums.friction_loss -= contact.axial * contact.slip_rate_axial + contact.lateral * contact.slip_rate_lateral;
    }
  }
}

double held_power(const LineAssembly& line, const LineState& state, int node) {
  const std::array<double, 6>& force = line.held_force(node);
  const std::size_t first = 6 * static_cast<std::size_t>(node);
  double sum = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    sum += force[i] * state.v[first + i];
  }
  return sum;
}

/// Velocity of a body-fixed point.
Vec3 carried_at(const RigidMotion& body, const Vec3& point) {
  return body.velocity + body.omega.cross(point - body.pose.p_WV);
}

}  // namespace

InstantEnergy Assembly::energy(const SystemState& state) const {
  InstantEnergy sums;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = lines_[i];
    const LineState& line_state = state.lines[i];
    add(sums.line, line.energy(line_state, surroundings_.water[i]));
    line.add_attached_energy(line_state, surroundings_.water[i], sums.line, sums.top_power);
    sums.line.strain += line.stored_by_yielding();
    sums.bending_heat += line_state.bending_heat;
    add_contact_energy(line.contacts(), sums);
    sums.anchor_power += held_power(line, line_state, line.end_node(LineEnd::first));
    sums.top_power += held_power(line, line_state, line.end_node(LineEnd::last));
  }
  add_wire_energy(sums);
  add_winch_power(state, sums);
  add_body_energy(state, sums);
  return sums;
}

void Assembly::find_working_ends(const SystemState& state, std::vector<WorkingEnd>& ends) const {
  ends.resize(system_->attachments.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const bool by_free_body = held.body != kGround && border_.free_body_number(held.body) >= 0;
    const std::size_t index = static_cast<std::size_t>(held.line);
    const LineAssembly& line = lines_[index];
    ends[i] = {};
    ends[i].last = held.end == LineEnd::last;
    const int node = held_node(held, line.line());
    std::copy_n(state.lines[index].q.begin() + 6 * node, 6, ends[i].place.begin());
    if (by_free_body) continue;
    ends[i].force = line.held_force(node);
    ends[i].power = held_power(line, state.lines[index], node);
  }
}

/// The work between wires and free bodies or lines is internal; bodies with prescribed motion do external work.
void Assembly::add_wire_energy(InstantEnergy& sums) const {
  for (std::size_t i = 0; i < wires().size(); ++i) {
    const Wire& wire = system_->wires[i];
    const WirePull& pull = wires()[i];
    if (!(pull.tension > 0.0)) continue;
    if (!wire.held_tension) sums.line.strain += 0.5 * pull.tension * pull.tension * wire.length / wire.axial_stiffness;
    const auto power = [&](int body, const Vec3& place, const Vec3& force) {
      if (body == kGround || border_.free_body_number(body) >= 0) return;
      sums.top_power += force.dot(carried_at(surroundings_.bodies[static_cast<std::size_t>(body)], place));
    };
    power(wire.first_body, pull.first, -pull.force);
    power(wire.second_body, pull.second, pull.force);
  }
}

/// A winch works on the line with the force that holds its end.
void Assembly::add_winch_power(const SystemState& state, InstantEnergy& sums) const {
  for (std::size_t i = 0; i < system_->attachments.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const double rate = state.attachments[i].payout.rate;
    if (held.winch && rate != 0.0) {
      const std::size_t index = static_cast<std::size_t>(held.line);
      const LineState& line_state = state.lines[index];
      const LineMotion motion =
          lines_[index].make_motion(line_state, line_state, {}, surroundings_.water[index], nullptr);
      sums.top_power += rate * lines_[index].energy_by_length({line_state.q.data(), nullptr}, motion);
    }
  }
}

/// The work between lines and free bodies is internal. The tensioner's power is the remainder of the end's power.
void Assembly::add_body_energy(const SystemState& state, InstantEnergy& sums) const {
  if (!border_.hinged().empty()) {
    const BodyEnergy hinged = border_.hinged().energy();
    sums.bodies.kinetic += hinged.kinetic;
    sums.bodies.stored += hinged.stored;
    sums.bodies.power += hinged.power;
  }
  for (std::size_t k = 0; k < border_.count(); ++k) {
    const BodyEnergy springs = spring_energy(border_.body(k), state.bodies[k], state.time);
    sums.bodies.stored += springs.stored;
    sums.bodies.power += springs.power;
    if (border_.body(k).energy) {
      const BodyEnergy part = border_.body(k).energy(state.bodies[k], state.time, border_.balance(k));
      sums.bodies.kinetic += part.kinetic;
      sums.bodies.stored += part.stored;
      sums.bodies.power += part.power;
    }
    for (const Attachment& held : system_->attachments) {
      if (held.end != LineEnd::inner && border_.free_body_number(held.body) == static_cast<int>(k)) {
        const std::size_t line = static_cast<std::size_t>(held.line);
        double& power = held.end == LineEnd::first ? sums.anchor_power : sums.top_power;
        power -= border_.end_power(held, lines_[line], state);
      }
    }
  }
  for (const LineAssembly& line : lines_) {
    const RollerContacts& rollers = line.contacts();
    for (int i = 0; i < (border_.empty() ? 0 : rollers.count()); ++i) {
      const RollerContact& contact = rollers.contacts()[static_cast<std::size_t>(i)];
      if (border_.free_body_number(rollers.roller_body(i)) >= 0 && contact.penetration > 0.0) {
        const RigidMotion& body = surroundings_.bodies[static_cast<std::size_t>(rollers.roller_body(i))];
        sums.roller_power -= contact.force().dot(carried_at(body, contact.closest.place));
      }
    }
  }
}

}  // namespace overbend
