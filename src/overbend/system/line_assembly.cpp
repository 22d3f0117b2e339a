#include "system/line_assembly.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/ranges.h"
#include "base/simd.h"
#include "mechanics/point_load.h"
#include "mechanics/quadrature.h"

namespace overbend {

LineAssembly::LineAssembly(const Line& line, const std::vector<Body>& bodies, BlockTridiagonal& tangent)
    : line_(&line),
      environment_(line.environment),
      yielding_(line.yielding),
      points_(line.points),
      wires_(line.wires),
      wire_ends_(line.wires.size()),
      wire_pulls_(line.wires.size()),
      contacts_(line, bodies),
      moving_yielding_(line.yielding, line.mesh),
      residual_(6 * static_cast<std::size_t>(line.mesh.nodes())),
      cuts_(residual_.size()),
      kept_{{0}, {line.mesh.nodes() - 1}},
      tangent_(&tangent) {
  for (int node = 0; node < line.mesh.nodes(); ++node) {
    const double h = line.mesh.min_neighbour_length(node);
    by_moments_.push_back(1.0 / (h * h));
  }
}

void LineAssembly::set(const Continuation& continuation) {
  continuation_ = continuation;
  contacts_.set(continuation);
  environment_.bed_stiffness = std::min(line_->environment.bed_stiffness, continuation.max_bed_stiffness);
  environment_.bed_stick = std::min(line_->environment.bed_stick, continuation.max_bed_stiffness);
  environment_.bed_relief = continuation.bed_relief;
  environment_.bed_level = continuation.bed_level;
  environment_.current_scale = continuation.current * line_->environment.current_scale;
  points_ = line_->points;
  for (LinePoint& point : points_) scale_forces(point, continuation.attached);
  wires_ = line_->wires;
  for (LineWire& wire : wires_) {
    wire.wire.axial_stiffness *= continuation.attached;
    wire.share = continuation.attached;
  }
  softened_.reset();
  if (continuation.max_axial_stiffness < Continuation{}.max_axial_stiffness) {
    softened_ = elements();
    for (double& stiffness : softened_->EA) stiffness = std::min(stiffness, continuation.max_axial_stiffness);
  }
}

void LineAssembly::set_wire_ends(const std::vector<RigidMotion>& bodies) {
  for (std::size_t i = 0; i < wires_.size(); ++i) wire_ends_[i] = wire_end(wires_[i].wire, bodies);
}

void LineAssembly::add_attached_forces(const LineState& state, const LineMotion& motion, bool with_tangent) {
  BlockTridiagonal* const tangent = with_tangent ? tangent_ : nullptr;
  add_point_forces(points_, environment_, state.q.data(), motion, residual_.data(), tangent);
  add_wire_forces(wires_, wire_ends_, state.q.data(), residual_.data(), tangent, wire_pulls_);
}

void LineAssembly::add_attached_energy(const LineState& state, const std::vector<double>& water, LineEnergy& sum,
                                       double& power) const {
  const LineMotion motion = make_motion(state, state, {}, water, nullptr);
  add_point_energy(points_, environment_, state.q.data(), motion, sum);
  add_wire_energy(wires_, wire_ends_, wire_pulls_, sum, power);
}

void LineAssembly::set_lateral_offset(double to_port) {
  environment_.route_offset = line_->environment.route_offset + to_port;
  environment_.route_shift = line_->environment.route_shift + to_port;
}

void LineAssembly::set_last_element(double length) {
  if (length <= 0.0) {
    paid_.reset();
    return;
  }
  if (!paid_ || paid_->count != line_->elements.count) {
    paid_ = line_->elements;
  }
  const auto last = static_cast<std::size_t>(paid_->count) - 1;
  paid_->length[last] = length;
  paid_->damping[last] = 0.0;  // its strain rate does not follow from the velocities of its nodes alone
}

double LineAssembly::energy_by_length(const LineShape& shape, const LineMotion& motion) const {
  constexpr double kShare = 1e-4;  // of the element; central difference
  if (!paid_) {
    return 0.0;
  }
  double& length = paid_->length[static_cast<std::size_t>(paid_->count) - 1];
  const double current_length = length, part = kShare * current_length;
  const auto energy = [&](double longer) {
    length = current_length + longer;
    const LineEnergy e = line_energy(*paid_, environment_, shape, motion, best_isa());
    return e.kinetic + e.strain + e.gravity + e.seabed;
  };
  const double more = energy(part), less = energy(-part);
  length = current_length;
  return (more - less) / (2.0 * part);
}

LineEnergy LineAssembly::energy(const LineState& state, const std::vector<double>& water) const {
  if (energy_) return *energy_;
  const LineMotion motion = make_motion(state, state, {}, water, nullptr);
  return line_energy(elements(), environment_, {state.q.data(), nullptr}, motion, best_isa());
}

LineTarget LineAssembly::target(bool with_tangent) {
  if (!with_tangent) {
    return {residual_.data(), nullptr, nullptr, nullptr, cuts_.data()};
  }
  return {residual_.data(), tangent_->diag(0), tangent_->upper(0), tangent_->lower(0), cuts_.data()};
}

void LineAssembly::keep_forces() {
  for (HeldForce& held : kept_) std::copy_n(residual_.begin() + 6 * held.node, 6, held.force.begin());
}

const std::array<double, 6>& LineAssembly::held_force(int node) const {
  return ranges::find(kept_, node, &HeldForce::node)->force;
}

std::vector<RollerPush> LineAssembly::roller_pushes(const LineState& state) const {
  std::vector<RollerPush> pushes;
  for (const RollerContact& contact : contacts_.contacts()) {
    if (contact.normal <= 0.0) continue;
    const auto e = static_cast<std::size_t>(contact.closest.element);
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * e));
    const CentrelinePoint centre_point = centreline(q, contact.closest.xi, line_->mesh.length[e]);
    const Vec3 load =
        point_load(elements(), environment_, contact.closest.element, centre_point.r, centre_point.a).sum();
    const double tension = Eigen::Map<const Vec3>(cuts_.data() + 6 * (e + 1)).dot(centre_point.a.normalized());
    pushes.push_back({contact.closest.element, contact.closest.xi, contact.force(),
                      load + tension * curvature_vector(centre_point), elements().EI[e]});
  }
  ranges::sort(pushes, [](const RollerPush& a, const RollerPush& b) {
    return a.element != b.element ? a.element > b.element : a.xi > b.xi;
  });
  return pushes;
}

void LineAssembly::evaluate_at_rest(const std::vector<RigidMotion>& bodies, const LineState& state, LayHistory history,
                                    bool with_tangent, bool keep_memory) {
  const LineTarget target = this->target(with_tangent);
  add_line_forces(elements(), environment_, state.shape(), target, best_isa());
  contacts_.place(bodies, state.q.data(), 0.0);
  contacts_.evaluate_at_rest(state.q.data(), {residual_, cuts_});
  if (yielding_.any && continuation_.yielding > 0.0) {
    choose_levels(yielding_, state.q.data());
    const StaticYield how{history, continuation_.yielding, before_.empty() ? nullptr : before_.data(),
                          roller_pushes(state)};
    add_static_yielding(yielding_, line_->mesh, how, state.shape(), keep_memory, resting_,
                        {&residual_, with_tangent ? tangent_ : nullptr, &cuts_});
  }
  set_wire_ends(bodies);
  add_attached_forces(state, {}, with_tangent);
  keep_forces();
  if (with_tangent) {
    contacts_.add_tangent(state.q.data(), {}, *tangent_);
  }
}

LineMotion LineAssembly::make_motion(const LineState& state, const LineState& before, const Weights& weights,
                                     const std::vector<double>& water, double* next_slip) const {
  LineMotion motion;
  motion.v = state.v.data();
  motion.acc = state.acc.data();
  motion.velocity_share = weights.velocity;
  motion.acceleration_share = weights.acceleration;
  motion.step = weights.step;
  motion.water = water.empty() ? nullptr : water.data();
  motion.bed_slip = before.bed_slip.data();
  motion.bed_slip_next = next_slip;
  return motion;
}

void LineAssembly::evaluate(LineState& state, const LineState& before, const Weights& weights,
                            const std::vector<double>& water, bool with_tangent, ContactMode contacts) {
  LineTarget target = this->target(with_tangent);
  // The last evaluation of a step needs its energies: rarely the first, or one with a tangent.
  energy_.reset();
  if (!with_tangent && contacts == ContactMode::free) target.energy = &energy_.emplace();
  LineMotion motion = make_motion(state, before, weights, water, state.bed_slip.data());
  HeldSections held;
  if (yielding_.any) {
    if (begins_) moving_yielding_.begin(before.bending, state.bending);
    held = moving_yielding_.held(before.bending, state.bending);
    motion.held = &held;
  }
  begins_ = false;
  add_line_forces(elements(), environment_, {state.q.data(), nullptr}, motion, target, best_isa());
  if (yielding_.any) {
    state.bending_heat =
        before.bending_heat + moving_yielding_.add_sliding(state.q.data(), before.bending, state.bending,
                                                           {&residual_, with_tangent ? tangent_ : nullptr, &cuts_});
  }
  add_attached_forces(state, motion, with_tangent);
  contacts_.evaluate(state.q.data(), state.v.data(), weights, before.contacts, state.contacts, contacts,
                     {residual_, cuts_});
  keep_forces();
  if (with_tangent) {
    if (without_contacts_.nodes() == 0) {  // not needed at rest
      without_contacts_.resize(line_->mesh.nodes());
    }
    const int nodes = line_->mesh.nodes(), first = contacts_.first_within_reach(nodes);
    kept_from_ = first < nodes ? std::min(first, tangent_->middle()) : nodes;
    if (first < nodes) without_contacts_.copy_from(*tangent_, kept_from_);
    contacts_.add_tangent(state.q.data(), weights, *tangent_);
  }
}

void LineAssembly::finish_step(LineState& state, const LineState& before) {
  contacts_.complete(state.q.data(), state.v.data(), state.contacts);
  if (yielding_.any) moving_yielding_.finish(before.bending, state.bending);
}

bool LineAssembly::renew_contact_tangents(const LineState& state, const Weights& weights) {
  const int nodes = line_->mesh.nodes();
  if (contacts_.first_carrying(nodes) < kept_from_ || kept_from_ == 0 || kept_from_ >= nodes) {
    return false;
  }
  tangent_->copy_from(without_contacts_, kept_from_);
  contacts_.add_tangent(state.q.data(), weights, *tangent_);
  return true;
}

void LineAssembly::hold(int node, const HeldDirections& held, bool blocks) {
  hold_node(node, held, residual_, blocks ? tangent_ : nullptr);
}

Unbalance LineAssembly::unbalance() const {
  Unbalance maximum;
  double worst = 0.0;
  for (int node = 0; node < line_->mesh.nodes(); ++node) {
    const double* r = residual_.data() + 6 * node;
    const double force = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
    const double moment = by_moments_[static_cast<std::size_t>(node)] * (r[3] * r[3] + r[4] * r[4] + r[5] * r[5]);
    if (force <= worst && moment <= worst) {
      continue;
    }
    worst = std::max(force, moment);
    if (!(force + moment < std::numeric_limits<double>::infinity())) {  // a maximum would ignore NaN
      return {std::numeric_limits<double>::infinity(), node};
    }
    maximum.node = node;
  }
  maximum.force = std::sqrt(worst);
  return maximum;
}

}  // namespace overbend
