// Contacts of a line at rest.
#include <algorithm>

#include "system/contact_point.h"
#include "system/roller_contacts.h"

namespace overbend {

/// Full friction of a line at rest.
void RollerContacts::rub(std::size_t index, const RollerDistance& distance, const NormalForce& normal) {
  const BodyRoller& roller = *rollers_[index].roller;
  RollerContact& contact = contacts_[index];
  const double across = roller.position == RollerPosition::bottom ? continuation_.roller_friction.across : 0.0;
  const MobilisedFrictionForce force{continuation_.roller_friction.along * roller.law.friction_axial,
                                     across * roller.law.friction_lateral, normal.force, normal.by_penetration};
  contact.axial_direction = contact.closest.tangent.normalized();  // perpendicular to the distance at the closest point
  contact.lateral_direction = distance.direction.cross(contact.axial_direction);
  contact.axial = force.along * normal.force;
  contact.lateral = force.across * normal.force;
  carrying_[index].rub = force;
}

void RollerContacts::evaluate_at_rest(const double* q, const ContactTarget& target) {
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    evaluate_one_at_rest(i, q, target);
  }
}

void RollerContacts::evaluate_one_at_rest(std::size_t index, const double* q, const ContactTarget& target) {
  const BodyRoller& roller = *rollers_[index].roller;
  RollerContact& contact = contacts_[index];
  contact = RollerContact{};
  contact.penetration = 0.0;
  carrying_[index].carries = false;
  if (!continuation_.side_rollers && roller.position != RollerPosition::bottom) {
    return;
  }
  const std::vector<double>& length = line_->mesh.length;
  const ElementRange range = within_reach(rollers_[index]);
  contact.closest = closest_point(placed_[index], q, length.data(), range.first, range.last);
  if (!contact.closest.found) {
    return;
  }
  RollerDistance distance = roller_distance(placed_[index], contact.closest);
  measure(index, distance, true);
  ContactLaw law = roller.law;
  law.stiffness = std::min(law.stiffness, continuation_.max_roller_stiffness);
  const NormalForce normal = normal_force(law, contact.penetration, 0.0);
  contact.normal = normal.force;
  if (normal.force <= 0.0) {
    return;
  }
  carrying_[index] = {true, distance, normal, {}, {}};
  if (continuation_.roller_friction.any()) {
    rub(index, distance, normal);
  }
  push(index, hermite(contact.closest.xi, length[static_cast<std::size_t>(contact.closest.element)]).value, target);
}

}  // namespace overbend
