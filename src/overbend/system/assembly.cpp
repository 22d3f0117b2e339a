#include "system/assembly.h"

#include <algorithm>
#include <cmath>

#include "base/simd.h"
#include "mechanics/quadrature.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<Vec3>;

Vec3Map vec(std::vector<double>& values, int node, int first) {
  return Vec3Map(values.data() + 6 * node + first);
}

void impose(LineState& state, int node, const Attachment& held, const EndMotion& motion, const MotionValues& guide) {
  if (held.hold_place) {
    vec(state.q, node, 0) = motion.place;
    vec(state.v, node, 0) = motion.velocity;
    vec(state.acc, node, 0) = motion.acceleration;
  }
  if (held.hold_direction) {
    vec(state.q, node, 3) = guide.q * motion.direction;
    vec(state.v, node, 3) = guide.v * motion.direction + guide.q * motion.direction_rate;
    vec(state.acc, node, 3) =
        guide.acc * motion.direction + 2.0 * guide.v * motion.direction_rate + guide.q * motion.direction_acceleration;
  }
}

/// The motion of a place that has been paid out by `travel` against the guide's direction.
EndMotion paid_out(EndMotion motion, const MotionValues& travel) {
  motion.place -= travel.q * motion.direction;
  motion.velocity -= travel.v * motion.direction + travel.q * motion.direction_rate;
  motion.acceleration -=
      travel.acc * motion.direction + 2.0 * travel.v * motion.direction_rate + travel.q * motion.direction_acceleration;
  return motion;
}

/// The motion of a place that has been dragged along.
EndMotion dragged(EndMotion motion, const GivenWay& way) {
  motion.place += way.dragged;
  motion.velocity += way.drag_rate;
  return motion;
}

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

double end_power(const LineAssembly& line, const LineState& state, LineEnd end) {
  const std::array<double, 6>& force = line.end_force(end);
  const std::size_t first = 6 * static_cast<std::size_t>(line.end_node(end));
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

Assembly::Assembly(const System& system)
    : system_(&system),
      border_(system),
      solver_(border_.lines(), border_.unknowns()),
      solution_(system.lines.size()),
      held_(system.attachments.size()) {
  lines_.reserve(system.lines.size());
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    lines_.emplace_back(system.lines[i], system.bodies, solver_.line(static_cast<int>(i)));
  }
  for (const int body : overbend::free_bodies(system)) {
    hold_hinged(body);
  }
  surroundings_.bodies.resize(system.bodies.size());
  surroundings_.ends.resize(system.attachments.size());
  surroundings_.water.resize(system.lines.size());
}

/// A body on a hinge has one freedom, which the ship may hold as well.
void Assembly::hold_hinged(int body) {
  const std::optional<HingedBody>& hinge = system_->bodies[static_cast<std::size_t>(body)].free->hinge;
  for (int freedom = 0; freedom < (hinge ? 6 : 0); ++freedom) {
    hold_body(body, freedom, freedom != kHingeFreedom || hinge->held);
  }
}

Increments Assembly::increments() const {
  Increments dq;
  for (const LineAssembly& line : lines_) {
    dq.emplace_back(line.residual().size());
  }
  if (!border_.empty()) {
    dq.emplace_back(border_.residual().size());
  }
  return dq;
}

std::uint64_t Assembly::contact_signature() const {
  std::uint64_t signature = 0;
  for (const LineAssembly& line : lines_) {
    signature = signature * 0x100000001b3ull + line.contacts().signature();
  }
  return signature;
}

bool Assembly::contacts_settled() const {
  return std::all_of(lines_.begin(), lines_.end(), [](const LineAssembly& l) { return l.contacts().settled(); });
}

bool Assembly::governed(std::size_t attachment) const {
  return static_cast<int>(attachment) == system_->machine && drive_ == TensionerDrive::governor &&
         system_->attachments[attachment].hold_place;
}

void Assembly::find_held() {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Attachment& attachment = system_->attachments[i];
    const Vec3& direction = surroundings_.ends[i].direction;
    held_[i] = HeldDirections{};
    if (attachment.hold_place) {
      held_[i].position = governed(i) ? across(direction) : all_directions();
    }
    if (attachment.hold_direction) {
      held_[i].tangent = across(direction);
    }
  }
}

void Assembly::set_time(double time, const SystemState& near) {
  constexpr double kReach = 0.5;  // further than any node moves in a step [m]
  system_->surroundings(time, surroundings_);
  if (!border_.empty()) {
    border_.lead(near.bodies, surroundings_);
    border_.meet_water(time);
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].contacts().place(surroundings_.bodies, near.lines[i].q.data(), kReach);
  }
  find_held();
}

void Assembly::set_drive(TensionerDrive drive) {
  drive_ = drive;
  find_held();
}

/// The force of the governor along the pipe: it grows with the speed of paying out, which the end's place makes. Of its
/// parts that along the guide alone is free.
void Assembly::add_governor(const SystemState& state) {
  const std::size_t machine = static_cast<std::size_t>(system_->machine);
  const Attachment& held = system_->attachments[machine];
  LineAssembly& line = lines_[static_cast<std::size_t>(held.line)];
  const Vec3& d = surroundings_.ends[machine].direction;
  const double tension = governed_tension(held.tensioner, state.attachments[machine].travel.v);
  vec(line.residual(), line.end_node(held.end), 0) -= tension * machine_axis_.dot(d) * d;
}

void Assembly::add_governor_tangent(const SystemState& state, const Weights& weights) {
  const std::size_t machine = static_cast<std::size_t>(system_->machine);
  const Attachment& held = system_->attachments[machine];
  LineAssembly& line = lines_[static_cast<std::size_t>(held.line)];
  const Vec3& d = surroundings_.ends[machine].direction;
  const double rate =
      governor_slope(held.tensioner, state.attachments[machine].travel.v) * weights.velocity * machine_axis_.dot(d);
  double* block = line.tangent().diag(line.end_node(held.end));
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      block[r * kRowWidth + c] += rate * d(r) * d(c);
    }
  }
}

/// A free body is where the state has it, and what it carries with it.
void Assembly::lead_bodies(const SystemState& state) {
  border_.lead(state.bodies, surroundings_);
  for (LineAssembly& line : lines_) {
    line.contacts().move(surroundings_.bodies);
  }
  find_held();
}

void Assembly::impose_ends(SystemState& state) {
  if (!border_.empty()) {
    lead_bodies(state);
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const std::size_t line = static_cast<std::size_t>(held.line);
    impose(state.lines[line], lines_[line].end_node(held.end), held,
           dragged(paid_out(surroundings_.ends[i], state.attachments[i].travel), state.attachments[i].way),
           state.attachments[i].guide);
  }
}

void Assembly::find_machine_axis(const SystemState& state) {
  if (system_->machine < 0) {
    return;
  }
  const std::size_t machine = static_cast<std::size_t>(system_->machine);
  const Attachment& held = system_->attachments[machine];
  const std::size_t line = static_cast<std::size_t>(held.line);
  const double* t = state.lines[line].q.data() + 6 * lines_[line].end_node(held.end) + 3;
  machine_axis_ =
      held.hold_direction ? surroundings_.ends[machine].direction : Vec3(Eigen::Map<const Vec3>(t)).normalized();
}

/// Lines of winches are as long as the state has them.
void Assembly::pay_out(const SystemState& state) {
  for (std::size_t i = 0; i < system_->attachments.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    if (held.winch) {
      lines_[static_cast<std::size_t>(held.line)].set_last_element(state.attachments[i].way.last_element);
    }
  }
}

void Assembly::evaluate(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent,
                        ContactMode contacts) {
  pay_out(state);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].evaluate(state.lines[i], before.lines[i], weights, surroundings_.water[i], with_tangent, contacts);
  }
  if (!border_.empty()) {
    border_.evaluate(state, before, weights, lines_, with_tangent);
    if (with_tangent) {
      put_border(state, weights);
    }
  }
  find_machine_axis(state);
  if (system_->machine >= 0 && governed(static_cast<std::size_t>(system_->machine))) {
    add_governor(state);
    if (with_tangent) {
      add_governor_tangent(state, weights);
    }
  }
}

void Assembly::put_border(const SystemState& state, const Weights& weights) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    border_.put_line(static_cast<int>(i), lines_[i], state, weights, held_, solver_);
  }
  border_.put_corner(solver_);
}

bool Assembly::renew_contacts(const SystemState& state, const Weights& weights) {
  const std::size_t machine = static_cast<std::size_t>(std::max(system_->machine, 0));
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (lines_[i].contacts().count() > 0 &&
        (border_.holds_first_end(static_cast<int>(i)) || !lines_[i].renew_contact_tangents(state.lines[i], weights))) {
      return false;
    }
  }
  for (std::size_t i = 0; i < (border_.empty() ? 0 : lines_.size()); ++i) {
    if (lines_[i].contacts().count() > 0) {
      border_.put_line(static_cast<int>(i), lines_[i], state, weights, held_, solver_);
    }
  }
  if (!border_.empty()) {
    border_.put_corner(solver_);
  }
  if (system_->machine >= 0 && governed(machine)) {
    add_governor_tangent(state, weights);
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    LineAssembly& line = lines_[static_cast<std::size_t>(system_->attachments[i].line)];
    const int node = line.end_node(system_->attachments[i].end);
    if (line.contacts().count() > 0 && node >= line.kept_from()) {
      line.hold(node, held_[i], true);
    }
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = lines_[i];
    if (line.contacts().count() > 0 && !solver_.factor_line(static_cast<int>(i), line.kept_from()).solved()) {
      return false;
    }
  }
  return solver_.close() < 0;
}

void Assembly::end_iteration(const SystemState& state) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].contacts().end_iteration(state.lines[i].contacts);
  }
}

void Assembly::hold(bool with_tangent) {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    LineAssembly& line = lines_[static_cast<std::size_t>(system_->attachments[i].line)];
    line.hold(line.end_node(system_->attachments[i].end), held_[i], with_tangent);
  }
}

double Assembly::relative_residual() {
  double worst = 0.0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Unbalance one = lines_[i].unbalance();
    const double relative = one.force / lines_[i].line().force_scale;
    if (i == 0 || relative > worst) {
      worst = relative;
      worst_ = {static_cast<int>(i), one.node};
    }
  }
  for (std::size_t i = 0; i < border_.count(); ++i) {
    const double relative = border_.relative_residual(i);
    if (!(relative <= worst)) {  // NaN too
      worst = relative;
      worst_ = {kBodyPlace, static_cast<int>(i)};
    }
  }
  return worst;
}

void Assembly::point_solution_at(Increments& dq) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    solution_[i] = dq[i].data();
  }
}

void Assembly::take_residual(Increments& dq) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const std::vector<double>& residual = lines_[i].residual();
    for (std::size_t k = 0; k < residual.size(); ++k) {
      dq[i][k] = -residual[k];
    }
  }
  for (std::size_t k = 0; k < border_.residual().size(); ++k) {
    dq.back()[k] = -border_.residual()[k];
  }
  point_solution_at(dq);
}

bool Assembly::solve_factored(Increments& dq) {
  take_residual(dq);
  return solver_.factor_and_solve(solution_, border_of(dq)).solved();
}

void Assembly::solve_again(Increments& dq) {
  take_residual(dq);
  solver_.solve(solution_, border_of(dq));
}

void Assembly::apply_factors(Increments& dq) {
  point_solution_at(dq);
  solver_.solve(solution_, border_of(dq));
}

void Assembly::hold_body(int body, int freedom, bool held) {
  border_.hold(body, freedom, held);
  solver_.hold(6 * border_.number_of(body) + freedom, held);
}

void Assembly::finish_step(const SystemState& before, double h, SystemState& after) const {
  for (std::size_t i = 0; i < border_.count(); ++i) {
    if (border_.body(i).finish_step) {
      border_.body(i).finish_step(before.bodies[i], h, after.bodies[i]);
    }
  }
}

double Assembly::machine_tension() const {
  if (system_->machine < 0) {
    return 0.0;
  }
  const Attachment& held = system_->attachments[static_cast<std::size_t>(system_->machine)];
  const std::array<double, 6>& force = lines_[static_cast<std::size_t>(held.line)].end_force(held.end);
  return Vec3(force[0], force[1], force[2]).dot(machine_axis_);
}

InstantEnergy Assembly::energy(const SystemState& state) const {
  InstantEnergy now;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const LineAssembly& line = lines_[i];
    const LineState& at = state.lines[i];
    const LineMotion motion = line.motion_of(at, at, {}, surroundings_.water[i], nullptr);
    add(now.line, line_energy(line.elements(), line.environment(), {at.q.data(), nullptr}, motion, best_isa()));
    add_point_energy(line.line().points, line.environment(), at.q.data(), motion, now.line);
    if (line.line().yielding.any) {
      now.line.strain += stored_by_yielding(line.line().yielding, line.line().mesh, at.q.data(), at.bending);
      now.bending_heat += at.bending_heat;
    }
    add_contact_energy(line.contacts(), now);
    now.anchor_power += end_power(line, at, LineEnd::first);
    now.top_power += end_power(line, at, LineEnd::last);
  }
  add_winch_power(state, now);
  add_body_energy(state, now);
  return now;
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
      const BodyEnergy one = border_.body(k).energy(state.bodies[k], state.time);
      now.bodies.kinetic += one.kinetic;
      now.bodies.stored += one.stored;
      now.bodies.power += one.power;
    }
    for (const Attachment& held : system_->attachments) {
      if (border_.number_of(held.body) == static_cast<int>(k)) {
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
        now.roller_power -= contact.force().dot(carried_at(body, contact.point));
      }
    }
  }
}

bool Assembly::find_accelerations(SystemState& state) {
  constexpr double kMassDominates = 1e16;  // weight of the mass at which stiffness is rounding [1/s2]
  const SystemState before = state;
  impose_ends(state);
  evaluate(state, before, {0.0, kMassDominates, 0.0}, true);
  hold(true);
  Increments dq = increments();
  if (!solve_factored(dq)) {
    return false;
  }
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    state.bodies[i].acc += kMassDominates * Eigen::Map<const Vec6>(dq.back().data() + 6 * i);
  }
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    for (std::size_t k = 0; k < dq[i].size(); ++k) {
      state.lines[i].acc[k] += kMassDominates * dq[i][k];
    }
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const std::size_t line = static_cast<std::size_t>(held.line);
    const double* at = dq[line].data() + 6 * lines_[line].end_node(held.end);
    const auto along = [&](const double* part) {
      return kMassDominates * surroundings_.ends[i].direction.dot(Vec3(Eigen::Map<const Vec3>(part)));
    };
    if (held.hold_direction) {
      state.attachments[i].guide.acc += along(at + 3);
    }
    if (governed(i)) {
      state.attachments[i].travel.acc -= along(at);
    }
  }
  if (!border_.empty()) {
    impose_ends(state);  // with the accelerations of the bodies
  }
  return true;
}

SystemState state_at_rest(const System& system, const std::vector<std::vector<double>>& q, double time) {
  std::size_t rollers = 0;
  for (const Body& body : system.bodies) {
    rollers += body.rollers.size();
  }
  SystemState state;
  state.time = time;
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    const Line& line = system.lines[i];
    LineState at;
    at.q = q[i];
    at.v.assign(at.q.size(), 0.0);
    at.acc.assign(at.q.size(), 0.0);
    at.alg.assign(at.q.size(), 0.0);
    at.bed_slip.assign(static_cast<std::size_t>(kGaussPoints * kBedDirections) * line.elements.padded(), 0.0);
    at.contacts.assign(line.on_rollers ? rollers : 0, ContactMemory{});
    if (line.yielding.any) {
      at.bending = fresh_memories(line.mesh, at.q.data());
    }
    state.lines.push_back(std::move(at));
  }
  for (const Attachment& held : system.attachments) {
    const std::vector<double>& at = q[static_cast<std::size_t>(held.line)];
    const std::size_t tangent = held.end == LineEnd::first ? 3 : at.size() - 3;
    AttachmentState of_end;
    of_end.guide = {Vec3(at[tangent], at[tangent + 1], at[tangent + 2]).norm(), 0.0, 0.0, 0.0};
    state.attachments.push_back(of_end);
  }
  for (const int body : overbend::free_bodies(system)) {
    state.bodies.push_back(system.bodies[static_cast<std::size_t>(body)].free->rest);
  }
  return state;
}

}  // namespace overbend
