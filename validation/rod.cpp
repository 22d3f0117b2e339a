#include "rod.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace overbend::validation {
namespace {

constexpr double kMaxRotation = 0.3;   ///< Rotation of a tangent in one step [rad].
constexpr double kSettledTurn = 1e-9;  ///< A step that turns no tangent by more ends the iteration [rad].

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return m;
}

LineElements rod_elements(const RodPipe& pipe, const std::vector<double>& lengths) {
  LineElements e;
  e.count = static_cast<int>(lengths.size());
  const std::size_t padded = (lengths.size() + kLanes - 1) / kLanes * kLanes;
  for (AlignedDoubles* array : {&e.EA, &e.EI, &e.damping, &e.weight, &e.buoyancy, &e.drag_normal, &e.drag_axial,
                                &e.pressure_constant, &e.pressure_slope, &e.pressure_external, &e.drag_on_bed}) {
    array->assign(padded, 0.0);
  }
  e.length.assign(padded, 1.0);
  e.compression.assign(padded, 1.0);
  e.radius.assign(padded, pipe.radius);
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    e.length[i] = lengths[i];
    e.EA[i] = pipe.EA;
    e.EI[i] = pipe.EI;
    e.weight[i] = pipe.weight;
  }
  return e;
}

}  // namespace

std::vector<double> equal_lengths(double length, int count) {
  return std::vector<double>(static_cast<std::size_t>(count), length / count);
}

Rod::Rod(const RodPipe& pipe, const std::vector<double>& lengths, const Vec3& start, const Vec3& direction)
    : pipe_(pipe), lengths_(lengths), elements_(rod_elements(pipe, lengths)), tangent_(nodes()) {
  const std::size_t unknowns = 6 * static_cast<std::size_t>(nodes());
  dead.assign(unknowns, 0.0);
  held_.assign(unknowns, 0);
  residual_.assign(unknowns, 0.0);
  state.q.resize(unknowns);
  for (int node = 0; node < nodes(); ++node) {
    Eigen::Map<Vec3>(state.q.data() + 6 * node) = start + s(node) * direction;
    Eigen::Map<Vec3>(state.q.data() + 6 * node + 3) = direction;
  }
}

double Rod::s(int node) const {
  double sum = 0.0;
  for (int e = 0; e < node; ++e) {
    sum += lengths_[static_cast<std::size_t>(e)];
  }
  return sum;
}

Vec3 Rod::position(int node) const {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node));
}

Vec3 Rod::tangent(int node) const {
  return Vec3(Eigen::Map<const Vec3>(state.q.data() + 6 * node + 3));
}

void Rod::clamp(int node) {
  for (const Dof dof : {kRx, kRy, kRz, kTx, kTy, kTz}) {
    hold(node, dof);
  }
}

void Rod::hold_in_plane() {
  for (int node = 0; node < nodes(); ++node) {
    hold(node, kRy);
    hold(node, kTy);
  }
}

void Rod::evaluate(bool with_tangent) {
  LineTarget target{residual_.data(), nullptr, nullptr, nullptr};
  if (with_tangent) {
    tangent_.resize(nodes());
    tangent_.set_zero();
    target = {residual_.data(), tangent_.diag(0), tangent_.upper(0), tangent_.lower(0)};
  }
  add_line_forces(elements_, surrounds, state.shape(), target, best_isa());
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    residual_[i] -= dead[i];
  }
  add_end_moment();
  add_rollers(with_tangent);
}

/// Work of a moment M on a turn of the tangent t: M . (t x dt) / t.t, so the tangent carries (M x t) / t.t.
void Rod::add_end_moment() {
  const int last = nodes() - 1;
  const Vec3 t = tangent(last);
  const double g = t.squaredNorm();
  const Vec3 force = end_moment.cross(t) / g;
  const Mat3 slope = cross_matrix(end_moment) / g - 2.0 * force * t.transpose() / g;
  for (int i = 0; i < 3; ++i) {
    residual_[static_cast<std::size_t>(6 * last + 3 + i)] -= force(i);
    for (int k = 0; k < 3; ++k) {
      tangent_.diag(last)[(3 + i) * kRowWidth + 3 + k] -= slope(i, k);
    }
  }
}

void Rod::add_rollers(bool with_tangent) {
  contacts_.assign(rollers.size(), RollerContact{});
  for (std::size_t i = 0; i < rollers.size(); ++i) {
    RollerContact& contact = contacts_[i];
    contact.closest = closest_point(rollers[i], state.q.data(), lengths_.data(), 0, elements_.count);
    if (!contact.closest.found) {
      continue;
    }
    const int node = contact.closest.element;
    const double h = lengths_[static_cast<std::size_t>(node)];
    const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * node));
    const RollerDistance distance = roller_distance(rollers[i], contact.closest);
    contact.normal_direction = distance.direction;
    contact.penetration = pipe_.radius + rollers[i].radius - distance.value;
    if (contact.penetration <= 0.0) {
      continue;
    }
    contact.normal = rollers[i].stiffness * contact.penetration;
    const RollerDistanceDerivatives d = roller_distance_derivatives(rollers[i], contact.closest, distance, q, h);
    for (int k = 0; k < 12; ++k) {
      residual_[static_cast<std::size_t>(6 * node + k)] -= contact.normal * d.gradient(k);
    }
    if (!with_tangent) {
      continue;
    }
    const ElementMatrix k = rollers[i].stiffness * d.gradient * d.gradient.transpose() - contact.normal * d.hessian;
    add_element(tangent_, node, k);
  }
}

void Rod::settle() {
  std::vector<double> dq(state.q.size());
  double worst = 0.0;
  for (int iteration = 0; iteration < 200; ++iteration) {
    evaluate(true);
    double max_force = 1e-300;
    worst = 0.0;
    for (int node = 0; node < nodes(); ++node) {
      for (int i = 0; i < kNodeDofs; ++i) {
        const std::size_t dof = static_cast<std::size_t>(6 * node + i);
        max_force = std::max({max_force, std::abs(residual_[dof]), std::abs(dead[dof])});
        worst = held_[dof] != 0 ? worst : std::max(worst, std::abs(residual_[dof]));
        tangent_.rhs(node, i, 0) = -residual_[dof];
      }
    }
    max_force = std::max(max_force, end_moment.norm());
    if (worst <= 1e-12 * max_force) {
      return;
    }
    for (int node = 0; node < nodes(); ++node) {
      for (int i = 0; i < kNodeDofs; ++i) {
        if (held_[static_cast<std::size_t>(6 * node + i)] == 0) {
          continue;
        }
        for (int c = 0; c < kNodeDofs; ++c) {  // the row only: its right-hand side is zero, so the unknown stays
          tangent_.diag(node)[i * kRowWidth + c] = c == i ? 1.0 : 0.0;
          if (node + 1 < nodes()) {
            tangent_.upper(node)[i * kRowWidth + c] = 0.0;
          }
          if (node > 0) {
            tangent_.lower(node - 1)[i * kRowWidth + c] = 0.0;
          }
        }
        tangent_.rhs(node, i, 0) = 0.0;
      }
    }
    if (!solve(tangent_).solved()) {
      throw std::runtime_error("validation rod: singular");
    }
    double turn = 0.0;
    for (int node = 0; node < nodes(); ++node) {
      for (int i = 0; i < kNodeDofs; ++i) {
        dq[static_cast<std::size_t>(6 * node + i)] = tangent_.rhs(node, i, 0);
      }
      turn = std::max(turn, Eigen::Map<const Vec3>(dq.data() + 6 * node + 3).norm());
    }
    const LineState from = state;
    advance(state, from, dq, std::min(1.0, kMaxRotation / std::max(turn, 1e-300)));
    if (turn < kSettledTurn) {
      return;
    }
  }
  throw std::runtime_error("validation rod: Newton does not settle, residual " + std::to_string(worst));
}

Vec3 Rod::reaction(int node) {
  evaluate(false);
  return Vec3(Eigen::Map<const Vec3>(residual_.data() + 6 * node));
}

ElementVector Rod::element_residual(int element) const {
  const LineElements line_elements = rod_elements(pipe_, {lengths_[static_cast<std::size_t>(element)]});
  alignas(64) double out[12] = {};
  const LineShape shape = state.shape();
  add_line_forces(line_elements, surrounds,
                  {shape.q + 6 * element, shape.low == nullptr ? nullptr : shape.low + 6 * element},
                  {out, nullptr, nullptr, nullptr}, best_isa());
  ElementVector residual(Eigen::Map<const ElementVector>(static_cast<const double*>(out)));
  for (const RollerContact& contact : contacts_) {
    if (contact.normal > 0.0 && contact.closest.element == element) {
      const HermiteValues n = hermite(contact.closest.xi, lengths_[static_cast<std::size_t>(element)]);
      for (int j = 0; j < 4; ++j) {
        residual.segment<3>(3 * j) -= contact.normal * n.value(j) * contact.normal_direction;
      }
    }
  }
  return residual;
}

Vec3 Rod::moment_at(int node) const {
  if (node == 0) {
    return -tangent(0).cross(Vec3(element_residual(0).segment<3>(3)));
  }
  return tangent(node).cross(Vec3(element_residual(node - 1).segment<3>(9)));
}

Vec3 Rod::moment_at_roller(std::size_t roller) const {
  const ClosestPoint& closest = contacts_[roller].closest;
  const double h = lengths_[static_cast<std::size_t>(closest.element)];
  const ElementVector g = element_residual(closest.element);
  const ElementVector q(Eigen::Map<const ElementVector>(state.q.data() + 6 * closest.element));
  // The stretch before the contact carries the cut at its first node and its weight.
  const Vec3 lever = centreline(q, closest.xi, h).r - q.segment<3>(0);
  const Vec3 weight(0.0, 0.0, -pipe_.weight * closest.xi * h);
  const Vec3 force = -g.segment<3>(0);
  const Vec3 start = -Vec3(q.segment<3>(3)).cross(Vec3(g.segment<3>(3)));
  return start - lever.cross(force) + 0.5 * lever.cross(weight);
}

}  // namespace overbend::validation
