// Energies and powers of what an assembly adds up.
#include "system/assembly.h"

#include <algorithm>

namespace overbend {
namespace {

/// Loss of a damped contact, which may have been let go while its spring was still compressed [W].
double normal_loss(const ContactLaw& law, const RollerContact& contact) {
  if (contact.penetration <= 0.0) {
    return 0.0;
  }
  return (contact.normal - law.stiffness * contact.penetration) * contact.rate;
}

void add(LineEnergy& sum, const LineEnergy& one) {
  sum.kinetic += one.kinetic;
  sum.strain += one.strain;
  sum.gravity += one.gravity;
  sum.seabed += one.seabed;
  sum.fluid_power += one.fluid_power;
  sum.seabed_loss += one.seabed_loss;
  sum.line_loss += one.line_loss;
}

void add_contact_energy(const RollerContacts& rollers, InstantEnergy& now) {
  for (int i = 0; i < rollers.count(); ++i) {
    const RollerContact& contact = rollers.contacts()[static_cast<std::size_t>(i)];
    const ContactLaw& law = rollers.roller(i).law;
    if (contact.penetration > 0.0) {
      now.contact += 0.5 * law.stiffness * contact.penetration * contact.penetration;
      now.contact_loss += normal_loss(law, contact);
      now.roller_power += contact.force().dot(contact.roller_velocity);
      now.friction_loss -= contact.axial * contact.slip_rate_axial + contact.lateral * contact.slip_rate_lateral;
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

/// Velocity of a point that goes with a body.
Vec3 carried_at(const RigidMotion& body, const Vec3& point) {
  return body.velocity + body.omega.cross(point - body.pose.p_WV);
}

}  // namespace

InstantEnergy Assembly::energy(const SystemState& state) const {
  InstantEnergy now;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = lines_[i];
    const LineState& at = state.lines[i];
    add(now.line, line.energy(at, surroundings_.water[i]));
    line.add_attached_energy(at, surroundings_.water[i], now.line, now.top_power);
    now.line.strain += line.stored_by_yielding();
    now.bending_heat += at.bending_heat;
    add_contact_energy(line.contacts(), now);
    now.anchor_power += held_power(line, at, line.end_node(LineEnd::first));
    now.top_power += held_power(line, at, line.end_node(LineEnd::last));
  }
  add_wire_energy(now);
  add_winch_power(state, now);
  add_body_energy(state, now);
  return now;
}

void Assembly::find_working_ends(const SystemState& state, std::vector<WorkingEnd>& ends) const {
  ends.resize(system_->attachments.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const bool by_free_body = held.body != kGround && border_.number_of(held.body) >= 0;
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

/// Free bodies and lines exchange with wires what stays inside; bodies whose motion is told put it in.
void Assembly::add_wire_energy(InstantEnergy& now) const {
  for (std::size_t i = 0; i < wires().size(); ++i) {
    const Wire& wire = system_->wires[i];
    const WirePull& pull = wires()[i];
    if (!(pull.tension > 0.0)) continue;
    if (!wire.held_tension) now.line.strain += 0.5 * pull.tension * pull.tension * wire.length / wire.axial_stiffness;
    const auto power = [&](int body, const Vec3& place, const Vec3& force) {
      if (body == kGround || border_.number_of(body) >= 0) return;
      now.top_power += force.dot(carried_at(surroundings_.bodies[static_cast<std::size_t>(body)], place));
    };
    power(wire.first_body, pull.first, -pull.force);
    power(wire.second_body, pull.second, pull.force);
  }
}

/// A winch works on the line with what it holds the end by.
void Assembly::add_winch_power(const SystemState& state, InstantEnergy& now) const {
  for (std::size_t i = 0; i < system_->attachments.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const double rate = state.attachments[i].way.rate;
    if (held.winch && rate != 0.0) {
      const std::size_t index = static_cast<std::size_t>(held.line);
      const LineState& at = state.lines[index];
      const LineMotion motion = lines_[index].motion_of(at, at, {}, surroundings_.water[index], nullptr);
      now.top_power += rate * lines_[index].energy_by_length({at.q.data(), nullptr}, motion);
    }
  }
}

/// What lines and free bodies do to each other is no power from outside. The tensioner's is what is left of the end's.
void Assembly::add_body_energy(const SystemState& state, InstantEnergy& now) const {
  if (!border_.hinged().empty()) {
    const BodyEnergy hinged = border_.hinged().energy();
    now.bodies.kinetic += hinged.kinetic;
    now.bodies.stored += hinged.stored;
    now.bodies.power += hinged.power;
  }
  for (std::size_t k = 0; k < border_.count(); ++k) {
    const BodyEnergy springs = spring_energy(border_.body(k), state.bodies[k], state.time);
    now.bodies.stored += springs.stored;
    now.bodies.power += springs.power;
    if (border_.body(k).energy) {
      const BodyEnergy one = border_.body(k).energy(state.bodies[k], state.time, border_.balance(k));
      now.bodies.kinetic += one.kinetic;
      now.bodies.stored += one.stored;
      now.bodies.power += one.power;
    }
    for (const Attachment& held : system_->attachments) {
      if (held.end != LineEnd::inner && border_.number_of(held.body) == static_cast<int>(k)) {
        const std::size_t line = static_cast<std::size_t>(held.line);
        double& power = held.end == LineEnd::first ? now.anchor_power : now.top_power;
        power -= border_.power_of_end(held, lines_[line], state);
      }
    }
  }
  for (const LineAssembly& line : lines_) {
    const RollerContacts& rollers = line.contacts();
    for (int i = 0; i < (border_.empty() ? 0 : rollers.count()); ++i) {
      const RollerContact& contact = rollers.contacts()[static_cast<std::size_t>(i)];
      if (border_.number_of(rollers.body_of(i)) >= 0 && contact.penetration > 0.0) {
        const RigidMotion& body = surroundings_.bodies[static_cast<std::size_t>(rollers.body_of(i))];
        now.roller_power -= contact.force().dot(carried_at(body, contact.at.place));
      }
    }
  }
}

}  // namespace overbend
