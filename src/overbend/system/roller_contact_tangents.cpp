// Derivatives of the contact forces by the unknowns of the line and by the rotation of bodies.
#include "system/contact_point.h"
#include "system/roller_contacts.h"

namespace overbend {
namespace {

/// N_i N_j A: the tangent of a force at a point that depends only on the motion of that point.
void add_point_stiffness(ElementMatrix& k, const HermiteValues& n, const Mat3& a) {
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      k.block<3, 3>(3 * i, 3 * j) += n.value(i) * n.value(j) * a;
    }
  }
}

}  // namespace

void RollerContacts::add_tangent(const double* q, const Weights& weights, BlockTridiagonal& tangent) const {
  for (int i = 0; i < count(); ++i) {
    if (carries(i)) {
      add_element(tangent, contacts_[static_cast<std::size_t>(i)].closest.element, contact_tangent(i, q, weights));
    }
  }
}

ElementMatrix RollerContacts::contact_tangent(int roller, const double* q, const Weights& weights) const {
  const std::size_t index = static_cast<std::size_t>(roller);
  const CarryingContact& carrying = carrying_[index];
  const NormalForce& normal = carrying.normal;
  const Vec3& away = carrying.distance.direction;
  const RollerContact& contact = contacts_[index];
  const double h = line_->mesh.length[static_cast<std::size_t>(contact.closest.element)];
  const HermiteValues n = hermite(contact.closest.xi, h);
  // Forces act at the point of the pipe: -d f / d q = N_i N_j (outer products of the directions). The rotation of the
  // friction directions beyond the Hessian of the distance is smaller by force over stiffness and distance, 1e-4, and
  // neglected.
  const RollerDistanceDerivatives d = roller_distance_derivatives(placed_[index], contact.closest, carrying.distance,
                                                                  element_unknowns(q, contact.closest.element), h);
  const double by_normal_motion = normal.by_penetration + normal.by_rate * weights.velocity;
  ElementMatrix k = -normal.force * d.hessian;
  Mat3 a = by_normal_motion * away * away.transpose();
  const auto add_friction = [&](const FrictionForce& force, const Vec3& direction) {
    a -= force.by_rate * weights.velocity * direction * direction.transpose();
    a += force.by_normal * by_normal_motion * direction * away.transpose();
  };
  add_friction(carrying.axial, contact.axial_direction);
  add_friction(carrying.lateral, contact.lateral_direction);
  add_point_stiffness(k, n, a);
  if (carrying.rub.along != 0.0 || carrying.rub.across != 0.0) {
    k += mobilised_friction_tangent(placed_[index], contact.closest, carrying.distance, d,
                                    element_unknowns(q, contact.closest.element), h, carrying.rub);
  }
  return k;
}

ElementVector RollerContacts::contact_residual(int roller) const {
  const RollerContact& contact = contacts_[static_cast<std::size_t>(roller)];
  ElementVector residual = ElementVector::Zero();
  const double h = line_->mesh.length[static_cast<std::size_t>(contact.closest.element)];
  add_point_force(residual.data(), hermite(contact.closest.xi, h).value, 0, 4, contact.force());
  return residual;
}

Eigen::Matrix<double, 12, 3> RollerContacts::contact_turning(int roller, const Weights& weights) const {
  const std::size_t index = static_cast<std::size_t>(roller);
  const RollerContact& contact = contacts_[index];
  const CarryingContact& carrying = carrying_[index];
  const std::size_t e = static_cast<std::size_t>(contact.closest.element);
  const Vec3& away = carrying.distance.direction;
  Mat3 a = Mat3::Zero();
  const auto add_friction = [&](const FrictionForce& force, const Vec3& direction) {
    a -= force.by_rate * weights.velocity * line_->elements.radius[e] * direction * away.cross(direction).transpose();
  };
  add_friction(carrying.axial, contact.axial_direction);
  add_friction(carrying.lateral, contact.lateral_direction);
  const HermiteValues n = hermite(contact.closest.xi, line_->mesh.length[e]);
  Eigen::Matrix<double, 12, 3> out;
  for (int i = 0; i < 4; ++i) {
    out.block<3, 3>(3 * i, 0) = n.value(i) * a;
  }
  return out;
}

}  // namespace overbend
