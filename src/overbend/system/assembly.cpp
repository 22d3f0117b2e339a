#include "system/assembly.h"

#include <algorithm>

#include "base/ranges.h"
#include "mechanics/quadrature.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<Vec3>;

Vec3Map vec(std::vector<double>& values, int node, int first) {
  return Vec3Map(values.data() + 6 * node + first);
}

void impose(LineState& state, int node, const Attachment& held, const EndMotion& motion, const MotionValues& guide) {
  if (held.hold_place) {
    const auto put = [&](std::vector<double>& values, const Vec3& held_at) {
      Vec3Map value = vec(values, node, 0);
      value = held.free_along ? Vec3(held_at + *held.free_along * held.free_along->dot(value - held_at)) : held_at;
    };
    put(state.q, motion.place);
    put(state.v, motion.velocity);
    put(state.acc, motion.acceleration);
  }
  if (held.hold_direction) {
    vec(state.q, node, 3) = guide.q * motion.direction;
    vec(state.v, node, 3) = guide.v * motion.direction + guide.q * motion.direction_rate;
    vec(state.acc, node, 3) =
        guide.acc * motion.direction + 2.0 * guide.v * motion.direction_rate + guide.q * motion.direction_acceleration;
  }
}

/// Motion of a point that has been paid out by `travel` against the guide's direction.
EndMotion paid_out(EndMotion motion, const MotionValues& travel) {
  motion.place -= travel.q * motion.direction;
  motion.velocity -= travel.v * motion.direction + travel.q * motion.direction_rate;
  motion.acceleration -=
      travel.acc * motion.direction + 2.0 * travel.v * motion.direction_rate + travel.q * motion.direction_acceleration;
  return motion;
}

/// Motion of a dragged anchor.
EndMotion dragged(EndMotion motion, const PayoutState& payout) {
  motion.place += payout.dragged;
  motion.velocity += payout.drag_rate;
  return motion;
}

/// Shared unknowns of each line: of free bodies, then far forces.
std::vector<BorderedLine> bordered_lines(const System& system, const BodyBorder& border) {
  std::vector<BorderedLine> lines = border.lines();
  for (std::size_t i = 0; i < system.far_forces.size(); ++i) {
    lines[static_cast<std::size_t>(system.far_forces[i])].unknowns.push_back(border.unknowns() + static_cast<int>(i));
  }
  return lines;
}

}  // namespace

Assembly::Assembly(const System& system)
    : system_(&system),
      border_(system),
      solver_(bordered_lines(system, border_), border_.unknowns() + static_cast<int>(system.far_forces.size())),
      target_errors_(system.far_forces.size()),
      solution_(system.lines.size()),
      held_(system.attachments.size()),
      residuals_(system.lines.size() + (border_.empty() ? 0 : 1)),
      fresh_from_(system.lines.size()) {
  for (const std::size_t attachment : find_tensioners(system)) tensioners_.push_back({attachment});
  lines_.reserve(system.lines.size());
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    lines_.emplace_back(system.lines[i], system.bodies, solver_.line(static_cast<int>(i)));
  }
  for (const Attachment& held : system.attachments) {
    if (held.end == LineEnd::inner) lines_[static_cast<std::size_t>(held.line)].keep_force(held.node);
  }
  for (const int body : overbend::free_bodies(system)) {
    hold_hinged(body);
    for (int freedom = 0; freedom < 6; ++freedom) {
      const bool held = system.bodies[static_cast<std::size_t>(body)].free->held[static_cast<std::size_t>(freedom)];
      if (held) hold_body(body, freedom, true);
    }
  }
  surroundings_.bodies.resize(system.bodies.size());
  surroundings_.ends.resize(system.attachments.size());
  surroundings_.water.resize(system.lines.size());
}

/// A hinged body has one freedom, which the vessel may also hold.
void Assembly::hold_hinged(int body) {
  const std::optional<HingedBody>& hinge = system_->bodies[static_cast<std::size_t>(body)].free->hinge;
  for (int freedom = 0; freedom < (hinge ? 6 : 0); ++freedom) {
    hold_body(body, freedom, freedom != kHingeFreedom || hinge->held);
  }
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

bool Assembly::is_governed(const Tensioner& tensioner) const {
  return tensioner.drive == TensionerDrive::governor && system_->attachments[tensioner.attachment].hold_place;
}

bool Assembly::governed(std::size_t attachment) const {
  return ranges::any_of(tensioners_, [&](const Tensioner& tensioner) {
    return tensioner.attachment == attachment && is_governed(tensioner);
  });
}

/// Sets the held directions of all attachments.
void Assembly::set_held_directions() {
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Attachment& attachment = system_->attachments[i];
    const Vec3& direction = surroundings_.ends[i].direction;
    held_[i] = HeldDirections{};
    if (attachment.hold_place) {
      held_[i].position = governed(i)             ? across(direction)
                          : attachment.free_along ? across(*attachment.free_along)
                                                  : all_directions();
    }
    if (attachment.hold_direction) {
      held_[i].tangent = across(direction);
    }
  }
}

void Assembly::set(const Continuation& continuation) {
  for (LineAssembly& line : lines_) line.set(continuation);
}

void Assembly::set_surroundings(double time) {
  system_->surroundings(time, surroundings_);
  set_held_directions();
}

void Assembly::set_time(double time, const SystemState& near) {
  constexpr double kReach = 0.5;  // more than any node moves in a step [m]
  system_->surroundings(time, surroundings_);
  if (!border_.idle()) {
    border_.lead(near.bodies, surroundings_);
    border_.evaluate_water(time);
    border_.begin_step();
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].contacts().place(surroundings_.bodies, near.lines[i].q.data(), kReach);
    lines_[i].set_wire_ends(surroundings_.bodies);
    lines_[i].begin_step();
  }
  set_held_directions();
}

void Assembly::set_drive(std::size_t tensioner, TensionerDrive drive) {
  tensioners_[tensioner].drive = drive;
  set_held_directions();
}

/// Adds the force of the governor along the pipe: it grows with the pay-out speed, which follows from the end's
/// position. Only its component along the guide acts on a free unknown.
void Assembly::add_governor(const Tensioner& tensioner, const SystemState& state) {
  const Attachment& held = system_->attachments[tensioner.attachment];
  LineAssembly& line = lines_[static_cast<std::size_t>(held.line)];
  const Vec3& d = surroundings_.ends[tensioner.attachment].direction;
  const double tension = governed_tension(*held.tensioner, state.attachments[tensioner.attachment].travel.v);
  vec(line.residual(), held_node(held, line.line()), 0) -= tension * tensioner.axis.dot(d) * d;
}

void Assembly::add_governor_tangent(const Tensioner& tensioner, const SystemState& state, const Weights& weights) {
  const Attachment& held = system_->attachments[tensioner.attachment];
  LineAssembly& line = lines_[static_cast<std::size_t>(held.line)];
  const Vec3& d = surroundings_.ends[tensioner.attachment].direction;
  const double rate = governor_slope(*held.tensioner, state.attachments[tensioner.attachment].travel.v) *
                      weights.velocity * tensioner.axis.dot(d);
  double* block = line.tangent().diag(held_node(held, line.line()));
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      block[r * kRowWidth + c] += rate * d(r) * d(c);
    }
  }
}

/// Moves the free bodies, and what they carry, to their positions in the state.
void Assembly::set_body_motions(const SystemState& state) {
  border_.lead(state.bodies, surroundings_);
  for (LineAssembly& line : lines_) {
    line.contacts().move(surroundings_.bodies);
    line.set_wire_ends(surroundings_.bodies);
  }
  set_held_directions();
}

void Assembly::impose_ends(SystemState& state) {
  if (!border_.idle()) {
    set_body_motions(state);
  }
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    const std::size_t line = static_cast<std::size_t>(held.line);
    impose(state.lines[line], held_node(held, system_->lines[line]), held,
           dragged(paid_out(surroundings_.ends[i], state.attachments[i].travel), state.attachments[i].payout),
           state.attachments[i].guide);
  }
}

void Assembly::find_axes(const SystemState& state) {
  for (Tensioner& tensioner : tensioners_) {
    const Attachment& held = system_->attachments[tensioner.attachment];
    const std::size_t line = static_cast<std::size_t>(held.line);
    const double* t = state.lines[line].q.data() + 6 * held_node(held, system_->lines[line]) + 3;
    tensioner.axis = held.hold_direction ? surroundings_.ends[tensioner.attachment].direction
                                         : Vec3(Eigen::Map<const Vec3>(t)).normalized();
  }
}

/// Sets the line lengths of winches from the state.
void Assembly::pay_out(const SystemState& state) {
  for (std::size_t i = 0; i < system_->attachments.size(); ++i) {
    const Attachment& held = system_->attachments[i];
    if (held.winch) {
      lines_[static_cast<std::size_t>(held.line)].set_last_element(state.attachments[i].payout.last_element);
    }
  }
}

void Assembly::evaluate(SystemState& state, const SystemState& before, const Weights& weights, bool with_tangent,
                        ContactMode contacts) {
  pay_out(state);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].evaluate(state.lines[i], before.lines[i], weights, surroundings_.water[i], with_tangent, contacts);
  }
  evaluate_bodies(state, before, weights, with_tangent);
  find_axes(state);
  for (const Tensioner& tensioner : tensioners_) {
    if (!is_governed(tensioner)) continue;
    add_governor(tensioner, state);
    if (with_tangent) add_governor_tangent(tensioner, state, weights);
  }
}

void Assembly::evaluate_at_rest(SystemState& state, LayHistory history, bool with_tangent) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].evaluate_at_rest(surroundings_.bodies, state.lines[i], history, with_tangent);
  }
  evaluate_bodies(state, state, {}, with_tangent);
}

void Assembly::evaluate_bodies(SystemState& state, const SystemState& before, const Weights& weights,
                               bool with_tangent) {
  if (border_.idle()) return;
  border_.evaluate(state, before, weights, lines_, with_tangent);
  if (!with_tangent || border_.empty()) return;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    border_.put_line(static_cast<int>(i), lines_[i], state, weights, held_, solver_);
  }
  border_.put_corner(solver_);
}

void Assembly::end_iteration(const SystemState& state) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].contacts().end_iteration(state.lines[i].contacts);
  }
}

void Assembly::forget_contacts() {
  for (LineAssembly& line : lines_) {
    line.contacts().forget();
  }
}

void Assembly::finish_step(const SystemState& before, double h, SystemState& after) {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    lines_[i].finish_step(after.lines[i], before.lines[i]);
  }
  for (std::size_t i = 0; i < border_.count(); ++i) {
    if (border_.body(i).finish_step) {
      border_.body(i).finish_step(before.bodies[i], h, after.bodies[i]);
    }
  }
}

double Assembly::tension(std::size_t tensioner) const {
  const Tensioner& of = tensioners_[tensioner];
  const Attachment& held = system_->attachments[of.attachment];
  const LineAssembly& line = lines_[static_cast<std::size_t>(held.line)];
  const std::array<double, 6>& force = line.held_force(held_node(held, line.line()));
  return Vec3(force[0], force[1], force[2]).dot(of.axis);
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
    LineState line_state;
    line_state.q = q[i];
    line_state.v.assign(line_state.q.size(), 0.0);
    line_state.acc.assign(line_state.q.size(), 0.0);
    line_state.algorithmic_acceleration.assign(line_state.q.size(), 0.0);
    line_state.bed_slip.assign(static_cast<std::size_t>(kGaussPoints * kBedDirections) * line.elements.padded(), 0.0);
    line_state.contacts.assign(line.on_rollers ? rollers : 0, ContactMemory{});
    if (line.yielding.any) {
      line_state.bending = BendingMemories(fresh_memories(line.mesh, line_state.q.data()));
    }
    state.lines.push_back(std::move(line_state));
  }
  for (const Attachment& held : system.attachments) {
    const auto line = static_cast<std::size_t>(held.line);
    const double* tangent = q[line].data() + 6 * held_node(held, system.lines[line]) + 3;
    AttachmentState of_end;
    of_end.guide = {Eigen::Map<const Vec3>(tangent).norm(), 0.0, 0.0, 0.0};
    state.attachments.push_back(of_end);
  }
  for (const int body : overbend::free_bodies(system)) {
    state.bodies.push_back(system.bodies[static_cast<std::size_t>(body)].free->rest);
  }
  return state;
}

}  // namespace overbend
