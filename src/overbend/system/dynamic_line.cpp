#include "system/dynamic_line.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/simd.h"
#include "mechanics/build_up.h"
#include "mechanics/quadrature.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<Vec3>;

Vec3Map vec(std::vector<double>& values, int node, int first) {
  return Vec3Map(values.data() + 6 * node + first);
}

void impose(DynamicState& state, int node, const LineEnd& end, const EndMotion& motion, const GuideValues& guide) {
  if (end.hold_place) {
    vec(state.q, node, 0) = motion.place;
    vec(state.v, node, 0) = motion.velocity;
    vec(state.acc, node, 0) = motion.acceleration;
  }
  if (end.hold_direction) {
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

/// Loss of a damped contact, which may have been let go while its spring was still compressed [W].
double normal_loss(const ContactLaw& law, const MovingContact& contact) {
  if (contact.penetration <= 0.0) {
    return 0.0;
  }
  return (contact.normal - law.stiffness * contact.penetration) * contact.rate;
}

}  // namespace

DynamicSystem::DynamicSystem(const DynamicLine& line)
    : line_(&line),
      contacts_(line.rollers, line.cells, line.shoe_V, line.mesh.length, line.elements.radius),
      residual_(6 * static_cast<std::size_t>(line.mesh.nodes())),
      cuts_(residual_.size()),
      plastic_moment_(line.yielding.any ? kGaussPoints * line.mesh.length.size() : 0, Vec3::Zero()),
      tangent_(line.mesh.nodes()),
      line_tangent_(line.mesh.nodes()) {}

HeldDirections DynamicSystem::held_by(const LineEnd& end, const EndMotion& motion, bool free_along) const {
  HeldDirections held;
  if (end.hold_place) {
    held.position = free_along ? across(motion.direction) : all_directions();
  }
  if (end.hold_direction) {
    held.tangent = across(motion.direction);
  }
  return held;
}

void DynamicSystem::set_time(double time, const DynamicState& near) {
  constexpr double kReach = 0.5;  // further than any node moves in a step [m]
  line_->surroundings(time, surroundings_);
  contacts_.place(surroundings_.vessel, near.q.data(), kReach);
  held_anchor_ = held_by(line_->anchor, surroundings_.anchor, false);
  held_top_ = held_by(line_->top, surroundings_.top, governed());
}

void DynamicSystem::set_drive(TensionerDrive drive) {
  drive_ = drive;
  held_top_ = held_by(line_->top, surroundings_.top, governed());
}

/// The force of the governor along the pipe: it grows with the speed of paying out, which the top's place makes. Of its
/// parts that along the guide alone is free.
void DynamicSystem::add_governor(const DynamicState& state) {
  const std::size_t first = residual_.size() - 6;
  const Vec3& d = surroundings_.top.direction;
  Vec3Map(residual_.data() + first) -= governed_tension(line_->tensioner, state.travel.v) * machine_axis_.dot(d) * d;
}

void DynamicSystem::add_governor_tangent(const DynamicState& state, const StepShares& shares) {
  const Vec3& d = surroundings_.top.direction;
  const double rate = governor_slope(line_->tensioner, state.travel.v) * shares.velocity * machine_axis_.dot(d);
  double* block = tangent_.diag(line_->mesh.nodes() - 1);
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      block[r * kRowWidth + c] += rate * d(r) * d(c);
    }
  }
}

void DynamicSystem::impose_ends(DynamicState& state) const {
  impose(state, 0, line_->anchor, surroundings_.anchor, state.anchor_guide);
  impose(state, line_->mesh.nodes() - 1, line_->top, paid_out(surroundings_.top, state.travel), state.top_guide);
}

LineMotion DynamicSystem::motion_of(const DynamicState& state, const DynamicState& before, const StepShares& shares,
                                    double* next_slip) const {
  LineMotion motion;
  motion.v = state.v.data();
  motion.acc = state.acc.data();
  motion.velocity_share = shares.velocity;
  motion.acceleration_share = shares.acceleration;
  motion.step = shares.step;
  motion.water = surroundings_.water.empty() ? nullptr : surroundings_.water.data();
  motion.bed_slip = before.bed_slip.data();
  motion.bed_slip_next = next_slip;
  return motion;
}

void DynamicSystem::evaluate(DynamicState& state, const DynamicState& before, const StepShares& shares,
                             bool with_tangent, ContactMode contacts) {
  std::fill(residual_.begin(), residual_.end(), 0.0);
  LineTarget target{residual_.data(), nullptr, nullptr, nullptr, cuts_.data()};
  if (with_tangent) {
    tangent_.set_zero();
    target = {residual_.data(), tangent_.diag(0), tangent_.upper(0), tangent_.lower(0), cuts_.data()};
  }
  const LineMotion motion = motion_of(state, before, shares, state.bed_slip.data());
  add_line_forces(line_->elements, line_->environment, {state.q.data(), nullptr}, motion, target, best_isa());
  if (line_->yielding.any) {
    state.bending_heat =
        before.bending_heat + add_moving_yielding(line_->yielding, line_->mesh, state.q.data(), before.bending,
                                                  state.bending, plastic_moment_,
                                                  {&residual_, with_tangent ? &tangent_ : nullptr, &cuts_});
  }
  contacts_.evaluate(state.q.data(), state.v.data(), shares, before.contacts, state.contacts, contacts,
                     {residual_, cuts_});
  std::copy_n(residual_.begin(), 6, anchor_residual_.begin());
  std::copy_n(residual_.end() - 6, 6, top_residual_.begin());
  machine_axis_ = line_->top.hold_direction
                      ? surroundings_.top.direction
                      : Vec3(Eigen::Map<const Vec3>(state.q.data() + state.q.size() - 3)).normalized();
  if (governed()) {
    add_governor(state);
  }
  if (with_tangent) {
    kept_from_ = contacts_.first_within_reach(line_->mesh.nodes());
    line_tangent_.copy_from(tangent_, kept_from_);
    add_contact_tangents(state, shares);
  }
}

void DynamicSystem::add_contact_tangents(const DynamicState& state, const StepShares& shares) {
  contacts_.add_tangent(state.q.data(), shares, tangent_);
  if (governed()) {
    add_governor_tangent(state, shares);
  }
}

bool DynamicSystem::renew_contacts(const DynamicState& state, const StepShares& shares) {
  const int nodes = line_->mesh.nodes();
  if (contacts_.first_carrying(nodes) < kept_from_ || kept_from_ == 0 || kept_from_ >= nodes) {
    return false;
  }
  tangent_.copy_from(line_tangent_, kept_from_);
  add_contact_tangents(state, shares);
  hold_node(nodes - 1, held_top_, residual_, &tangent_);
  return refactor(tangent_, kept_from_).solved();
}

void DynamicSystem::hold(bool with_tangent) {
  BlockTridiagonal* blocks = with_tangent ? &tangent_ : nullptr;
  hold_node(0, held_anchor_, residual_, blocks);
  hold_node(line_->mesh.nodes() - 1, held_top_, residual_, blocks);
}

double DynamicSystem::relative_residual() const {
  const std::vector<double>& length = line_->mesh.length;
  double worst = 0.0;
  for (int node = 0; node < line_->mesh.nodes(); ++node) {
    const std::size_t right = std::min(static_cast<std::size_t>(node), length.size() - 1);
    const double h = node == 0 ? length.front() : std::min(length[static_cast<std::size_t>(node) - 1], length[right]);
    const double* r = residual_.data() + 6 * node;
    const double force = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    const double moment = (r[3] * r[3] + r[4] * r[4] + r[5] * r[5]) / (h * h);
    const double size = std::max(force, moment);
    if (!(size < std::numeric_limits<double>::infinity())) {  // a maximum would pass over what is not a number
      worst_node_ = node;
      return std::numeric_limits<double>::infinity();
    }
    if (size > worst) {
      worst = size;
      worst_node_ = node;
    }
  }
  return std::sqrt(worst) / line_->force_scale;
}

bool DynamicSystem::solve_factored(std::vector<double>& dq) {
  const int n = line_->mesh.nodes();
  for (int node = 0; node < n; ++node) {
    for (int i = 0; i < kNodeDofs; ++i) {
      tangent_.rhs(node, i, 0) = -residual_[static_cast<std::size_t>(6 * node + i)];
    }
  }
  if (!solve(tangent_).solved()) {
    return false;
  }
  for (int node = 0; node < n; ++node) {
    for (int i = 0; i < kNodeDofs; ++i) {
      dq[static_cast<std::size_t>(6 * node + i)] = tangent_.rhs(node, i, 0);
    }
  }
  return true;
}

void DynamicSystem::solve_again(std::vector<double>& dq) {
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    dq[i] = -residual_[i];
  }
  resolve(tangent_, dq.data());
}

Vec3 DynamicSystem::top_force() const {
  return {top_residual_[0], top_residual_[1], top_residual_[2]};
}

InstantEnergy DynamicSystem::energy(const DynamicState& state) const {
  InstantEnergy now;
  const LineMotion motion = motion_of(state, state, {}, nullptr);
  now.line = line_energy(line_->elements, line_->environment, {state.q.data(), nullptr}, motion, best_isa());
  if (line_->yielding.any) {
    now.line.strain += stored_by_yielding(line_->yielding, line_->mesh, state.q.data(), state.bending);
    now.bending_heat = state.bending_heat;
  }
  for (int i = 0; i < contacts_.count(); ++i) {
    const MovingContact& contact = contacts_.contacts()[static_cast<std::size_t>(i)];
    const ContactLaw& law = contacts_.rollers()[static_cast<std::size_t>(i)].law;
    if (contact.penetration > 0.0) {
      now.contact += 0.5 * law.stiffness * contact.penetration * contact.penetration;
      now.contact_loss += normal_loss(law, contact);
      now.roller_power += contact.force().dot(contact.roller_velocity);
      now.friction_loss -= contact.axial * contact.slip_rate_axial + contact.lateral * contact.slip_rate_lateral;
    }
  }
  const auto power = [&](int node, const std::array<double, 6>& force) {
    double sum = 0.0;
    for (std::size_t i = 0; i < force.size(); ++i) {
      sum += force[i] * state.v[6 * static_cast<std::size_t>(node) + i];
    }
    return sum;
  };
  now.anchor_power = power(0, anchor_residual_);
  now.top_power = power(line_->mesh.nodes() - 1, top_residual_);
  return now;
}

bool DynamicSystem::find_accelerations(DynamicState& state) {
  constexpr double kMassDominates = 1e16;  // share of acceleration at which stiffness is rounding [1/s2]
  const int last = line_->mesh.nodes() - 1;
  const DynamicState before = state;
  impose_ends(state);
  evaluate(state, before, {0.0, kMassDominates, 0.0}, true);
  hold(true);
  std::vector<double> dq(state.q.size());
  if (!solve_factored(dq)) {
    return false;
  }
  for (std::size_t i = 0; i < dq.size(); ++i) {
    state.acc[i] += kMassDominates * dq[i];
  }
  const auto along = [&](int first, const EndMotion& motion) {
    return kMassDominates * motion.direction.dot(Vec3(Eigen::Map<const Vec3>(dq.data() + first)));
  };
  if (line_->anchor.hold_direction) {
    state.anchor_guide.acc += along(3, surroundings_.anchor);
  }
  if (line_->top.hold_direction) {
    state.top_guide.acc += along(6 * last + 3, surroundings_.top);
  }
  if (governed()) {
    state.travel.acc -= along(6 * last, surroundings_.top);
  }
  return true;
}

double tensioner_authority(const DynamicLine& line, double time) {
  return half_cosine(time, line.build_up).value;
}

DynamicState state_at_rest(const DynamicLine& line, const std::vector<double>& q, double time) {
  DynamicState state;
  state.time = time;
  state.q = q;
  state.v.assign(q.size(), 0.0);
  state.acc.assign(q.size(), 0.0);
  state.alg.assign(q.size(), 0.0);
  state.anchor_guide = {Vec3(q[3], q[4], q[5]).norm(), 0.0, 0.0, 0.0};
  const std::size_t top = q.size() - 3;
  state.top_guide = {Vec3(q[top], q[top + 1], q[top + 2]).norm(), 0.0, 0.0, 0.0};
  state.bed_slip.assign(static_cast<std::size_t>(kGaussPoints * kBedDirections) * line.elements.padded(), 0.0);
  state.contacts.assign(line.rollers.size(), ContactMemory{});
  if (line.yielding.any) {
    state.bending = fresh_memories(line.mesh, q.data());
  }
  return state;
}

}  // namespace overbend
