#include "system/moving_contacts.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

ElementVector dofs_of(const double* values, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(values + 6 * element));
}

/// Value at xi of a field given by its nodal values.
Vec3 at_point(const HermiteValues& n, const ElementVector& nodes) {
  return n.value(0) * nodes.segment<3>(0) + n.value(1) * nodes.segment<3>(3) + n.value(2) * nodes.segment<3>(6) +
         n.value(3) * nodes.segment<3>(9);
}

/// From place or tangent number `from` of an element on: 0 is all of it, 2 its upper node.
void add_force(double* element, const HermiteValues& n, int from, const Vec3& force) {
  for (int j = from; j < 4; ++j) {
    for (int i = 0; i < 3; ++i) {
      element[3 * j + i] -= n.value(j) * force(i);
    }
  }
}

/// N_i N_j A: the tangent of a force at a point that depends on the motion of that point alone.
void add_point_stiffness(ElementMatrix& k, const HermiteValues& n, const Mat3& a) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      k.block<3, 3>(3 * i, 3 * j) += n.value(i) * n.value(j) * a;
    }
  }
}

/// Bounds of the Bezier hull of an element in the ramp's frame.
ElementBounds bounds_of(const Vec3& r1, const Vec3& t1, const Vec3& r2, const Vec3& t2, double h, double reach) {
  const Vec3 b1 = r1 + h / 3.0 * t1;
  const Vec3 b2 = r2 - h / 3.0 * t2;
  return {std::min({r1.x(), r2.x(), b1.x(), b2.x()}) - reach, std::max({r1.x(), r2.x(), b1.x(), b2.x()}) + reach,
          std::min({r1.z(), r2.z(), b1.z(), b2.z()}) - reach};
}

/// In statics a roller holds the pipe on the side it is meant for; in time the pipe is where it is. It passes a roller
/// over its end alone, and one that has done so is pushed further out when it comes near, not back through the steel.
void turn_to_actual_side(RollerDistance& distance) {
  distance.value = -distance.value;
  distance.direction = -distance.direction;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {  // FNV-1a step
  return (hash ^ value) * 0x100000001b3ull;
}

}  // namespace

MovingContacts::MovingContacts(std::vector<MovingRoller> rollers, ContactCells cells, const Vec3& shoe_V,
                               const std::vector<double>& length, const AlignedDoubles& pipe_radius)
    : rollers_(std::move(rollers)),
      cells_(std::move(cells)),
      shoe_V_(shoe_V),
      length_(&length),
      pipe_radius_(&pipe_radius),
      placed_(rollers_.size()),
      bounds_(length.size()),
      ranges_(cells_.boxes.size()),
      contacts_(rollers_.size()),
      carrying_(rollers_.size()),
      iterate_(rollers_.size()) {}

void MovingContacts::place(const RigidMotion& vessel, const double* q, double reach) {
  vessel_ = vessel;
  if (rollers_.empty()) {
    return;
  }
  const Mat3& axes = vessel.pose.R_WV;
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    const MovingRoller& roller = rollers_[i];
    placed_[i] = {vessel.pose.p_WV + axes * roller.center_V,
                  axes * roller.axis_V,
                  axes * roller.normal_V,
                  roller.half_face,
                  roller.radius,
                  roller.law.stiffness};
  }
  const Vec3 origin = vessel.pose.p_WV + axes * shoe_V_;
  const Vec3 x_axis = -axes.col(0), z_axis = axes.col(2);
  const auto to_S = [&](const Vec3& v) { return Vec3(v.dot(x_axis), 0.0, v.dot(z_axis)); };
  const auto place_S = [&](int node) { return to_S(Vec3(Vec3Map(q + 6 * node)) - origin); };
  Vec3 r1 = place_S(0), t1 = to_S(Vec3Map(q + 3));
  for (std::size_t e = 0; e < length_->size(); ++e) {
    const int node = static_cast<int>(e) + 1;
    const Vec3 r2 = place_S(node), t2 = to_S(Vec3Map(q + 6 * node + 3));
    bounds_[e] = bounds_of(r1, t1, r2, t2, (*length_)[e], reach);
    r1 = r2;
    t1 = t2;
  }
  search_cells(cells_, bounds_, ranges_);
}

void MovingContacts::end_iteration(const std::vector<ContactMemory>& now) {
  for (std::size_t i = 0; i < now.size(); ++i) {
    iterate_[i] = {now[i].axial, now[i].lateral};
  }
}

void MovingContacts::evaluate(const double* q, const double* v, const StepShares& shares,
                              const std::vector<ContactMemory>& before, std::vector<ContactMemory>& after,
                              ContactMode mode, const ContactTarget& target) {
  signature_ = 0xcbf29ce484222325ull;
  settled_ = mode == ContactMode::free;
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    evaluate_one(i, q, v, shares, before[i], after[i], mode, target);
  }
}

void MovingContacts::evaluate_one(std::size_t index, const double* q, const double* v, const StepShares& shares,
                                  const ContactMemory& before, ContactMemory& after, ContactMode mode,
                                  const ContactTarget& target) {
  const MovingRoller& roller = rollers_[index];
  const PlacedRoller& placed = placed_[index];
  MovingContact& contact = contacts_[index];
  contact = MovingContact{};
  carrying_[index].carries = false;
  const ElementRange reachable = ranges_[static_cast<std::size_t>(roller.box)];
  const bool in_reach = reachable.first < reachable.last;
  const ElementRange range = in_reach ? reachable : ElementRange{0, static_cast<int>(length_->size())};
  contact.at = closest_point_near(placed, q, length_->data(), range.first, range.last, after.element, after.xi);
  const int last_element = after.element;
  const double last_xi = after.xi;
  after = {0.0, 0.0, false, Slip::stick, Slip::stick, last_element, last_xi};
  if (!contact.at.found) {
    return;
  }
  const int element = contact.at.element;
  after.element = element;
  after.xi = contact.at.xi;
  const std::size_t e = static_cast<std::size_t>(element);
  const double h = (*length_)[e];
  const ElementVector dofs = dofs_of(q, element);
  RollerDistance distance = roller_distance(placed, contact.at, dofs, h);
  if (distance.value < 0.0) {
    turn_to_actual_side(distance);
  }
  contact.penetration = (*pipe_radius_)[e] + roller.radius - distance.value;
  contact.normal_direction = distance.direction;
  const HermiteValues n = hermite(contact.at.xi, h);
  const Vec3 pipe = at_point(n, dofs);
  const Vec3 arm = pipe - (*pipe_radius_)[e] * distance.direction - vessel_.pose.p_WV;
  contact.roller_velocity = vessel_.velocity + vessel_.omega.cross(arm);
  const Vec3 slip_rate = at_point(n, dofs_of(v, element)) - contact.roller_velocity;
  contact.rate = -slip_rate.dot(distance.direction);
  const bool kept = mode == ContactMode::kept;
  if (!in_reach || (kept && !before.carries)) {  // out of reach the separation alone is of interest
    return;
  }
  const NormalForce normal = kept ? attached_force(roller.law, contact.penetration, contact.rate)
                                  : normal_force(roller.law, contact.penetration, contact.rate);
  contact.normal = normal.force;
  if (normal.by_penetration <= 0.0) {
    return;
  }
  const CentrelinePoint point = centreline(dofs, contact.at.xi, h);
  contact.axial_direction = (point.a - point.a.dot(distance.direction) * distance.direction).normalized();
  contact.lateral_direction = distance.direction.cross(contact.axial_direction);
  contact.slip_rate_axial = slip_rate.dot(contact.axial_direction);
  contact.slip_rate_lateral = slip_rate.dot(contact.lateral_direction);
  const auto friction = [&](double mu, double slip, double rate, Slip at_start, Slip last) {
    const SlipStep step{slip, rate, shares.step, normal.force};
    if (kept) {
      return friction_in_state(roller.law, mu, step, at_start);
    }
    const FrictionForce force = friction_force(roller.law, mu, step);
    if (static_cast<int>(force.state) * static_cast<int>(last) < 0) {  // between sliding either way the contact sticks
      settled_ = false;
      return friction_in_state(roller.law, mu, step, Slip::stick);
    }
    return force;
  };
  const FrictionForce axial = friction(roller.law.friction_axial, before.slip_axial, contact.slip_rate_axial,
                                       before.axial, iterate_[index].axial);
  const FrictionForce lateral = friction(roller.law.friction_lateral, before.slip_lateral, contact.slip_rate_lateral,
                                         before.lateral, iterate_[index].lateral);
  contact.axial = axial.force;
  contact.lateral = lateral.force;
  after = {axial.slip, lateral.slip, true, axial.state, lateral.state, after.element, after.xi};
  signature_ =
      mixed(signature_, 16 * index + (axial.state == Slip::stick ? 0u : 1u) + (lateral.state == Slip::stick ? 0u : 2u));
  add_force(target.residual.data() + 6 * element, n, 0, contact.force());
  add_force(target.cuts.data() + 6 * element, n, 2, contact.force());
  carrying_[index] = {true, distance, normal, axial, lateral};
}

int MovingContacts::first_within_reach(int beyond) const {
  int first = beyond;
  for (const ElementRange& range : ranges_) {
    first = range.first < range.last ? std::min(first, range.first) : first;
  }
  return first;
}

int MovingContacts::first_carrying(int beyond) const {
  int first = beyond;
  for (std::size_t i = 0; i < carrying_.size(); ++i) {
    first = carrying_[i].carries ? std::min(first, contacts_[i].at.element) : first;
  }
  return first;
}

void MovingContacts::add_tangent(const double* q, const StepShares& shares, BlockTridiagonal& tangent) const {
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    if (carrying_[i].carries) {
      add_tangent_of(i, q, shares, tangent);
    }
  }
}

void MovingContacts::add_tangent_of(std::size_t index, const double* q, const StepShares& shares,
                                    BlockTridiagonal& tangent) const {
  const CarryingContact& carrying = carrying_[index];
  const NormalForce& normal = carrying.normal;
  const Vec3& away = carrying.distance.direction;
  const MovingContact& contact = contacts_[index];
  const double h = (*length_)[static_cast<std::size_t>(contact.at.element)];
  const HermiteValues n = hermite(contact.at.xi, h);
  // Forces act at the point of the pipe: -d f / d q = N_i N_j (outer products of the directions). What the turning of
  // the directions adds beyond the Hessian of the distance is smaller by force over stiffness and distance, 1e-4.
  const RollerDistanceDerivatives d =
      roller_distance_derivatives(placed_[index], contact.at, carrying.distance, dofs_of(q, contact.at.element), h);
  const double by_normal_motion = normal.by_penetration + normal.by_rate * shares.velocity;
  ElementMatrix k = -normal.force * d.hessian;
  Mat3 a = by_normal_motion * away * away.transpose();
  const auto add_friction = [&](const FrictionForce& force, const Vec3& direction) {
    a -= force.by_rate * shares.velocity * direction * direction.transpose();
    a += force.by_normal * by_normal_motion * direction * away.transpose();
  };
  add_friction(carrying.axial, contact.axial_direction);
  add_friction(carrying.lateral, contact.lateral_direction);
  add_point_stiffness(k, n, a);
  add_element(tangent, contact.at.element, k);
}

}  // namespace overbend
