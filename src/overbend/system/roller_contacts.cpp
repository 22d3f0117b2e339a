#include "system/roller_contacts.h"

#include <algorithm>
#include <cmath>

#include "system/contact_point.h"

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

/// Bounds of the Bezier hull of an element in the ramp's frame.
ElementBounds make_element_bounds(const Vec3& r1, const Vec3& t1, const Vec3& r2, const Vec3& t2, double h,
                                  double reach) {
  const Vec3 b1 = r1 + h / 3.0 * t1;
  const Vec3 b2 = r2 - h / 3.0 * t2;
  return {std::min({r1.x(), r2.x(), b1.x(), b2.x()}) - reach, std::max({r1.x(), r2.x(), b1.x(), b2.x()}) + reach,
          std::min({r1.z(), r2.z(), b1.z(), b2.z()}) - reach};
}

/// At rest a roller holds the pipe on its nominal side; a moving pipe is on its actual side. It passes a roller only
/// over its end, and once past is pushed further out when it comes near, not back through the steel.
void turn_to_actual_side(RollerDistance& distance) {
  distance.value = -distance.value;
  distance.direction = -distance.direction;
}

/// Radius of the line at its contact with a roller [m]. Where it grows from one element to the next, at a head or a
/// built-in structure, the thick part begins with a cone of 1:2, so that no roller meets a step; the axial force of the
/// cone is neglected.
double contact_radius(const Line& line, std::size_t element, double xi) {
  constexpr double kConeSlope = 0.5;
  const AlignedDoubles& radius = line.elements.radius;
  const double element_radius = radius[element], h = line.mesh.length[element];
  double found = element_radius;
  const auto taper = [&](double thinner, double away) {
    const double step = element_radius - thinner;
    const double cone = std::min(step / kConeSlope, h);
    if (away < cone) found = std::min(found, thinner + step * away / cone);
  };
  if (element > 0 && radius[element - 1] < element_radius) taper(radius[element - 1], xi * h);
  if (element + 1 < line.mesh.length.size() && radius[element + 1] < element_radius) {
    taper(radius[element + 1], (1.0 - xi) * h);
  }
  return found;
}

/// Memory of a contact that does not carry; it keeps the closest point.
ContactMemory apart(const ContactMemory& memory) {
  return {0.0, 0.0, false, Slip::stick, Slip::stick, memory.element, memory.xi, memory.passing};
}

/// Slip direction of a contact whose friction pushes the pipe along or against its direction.
Slip slide(double push) {
  return push > 0.0 ? Slip::backward : Slip::forward;
}

std::uint64_t mixed(std::uint64_t hash, std::uint64_t value) {  // FNV-1a step
  return (hash ^ value) * 0x100000001b3ull;
}

}  // namespace

RollerContacts::RollerContacts(const Line& line, const std::vector<Body>& bodies)
    : line_(&line), bodies_(&bodies), bounds_(line.mesh.length.size()), motions_(bodies.size()) {
  for (std::size_t b = 0; b < (line.on_rollers ? bodies.size() : 0); ++b) {
    ranges_.emplace_back(bodies[b].cells.boxes.size());
    for (const BodyRoller& roller : bodies[b].rollers) {
      rollers_.push_back({&roller, b});
    }
  }
  placed_.resize(rollers_.size());
  contacts_.resize(rollers_.size());
  carrying_.resize(rollers_.size());
  iterate_.resize(rollers_.size());
  passed_over_.resize(rollers_.size());
  looked_at_.reserve(rollers_.size());
  looks_.reserve(rollers_.size());
  meetings_.resize(rollers_.size());
  reference_.q.resize(rollers_.empty() ? 0 : 6 * static_cast<std::size_t>(line.mesh.nodes()));
  reference_.placed.resize(rollers_.size());
  reference_.gap.resize(rollers_.size());
  max_length_ = *std::max_element(line.mesh.length.begin(), line.mesh.length.end());
}

void RollerContacts::place(const std::vector<RigidMotion>& bodies, const double* q, double reach) {
  move(bodies);
  if (moved_since_search_ <= 0.5 * reach && reach > 0.0) return;
  for (std::size_t b = 0; b < ranges_.size(); ++b) {
    if (!(*bodies_)[b].rollers.empty()) {
      search(b, q, 1.5 * reach);
    }
  }
  moved_since_search_ = reach > 0.0 ? 0.0 : kFar;
}

void RollerContacts::move(const std::vector<RigidMotion>& bodies) {
  for (std::size_t b = 0; b < ranges_.size(); ++b) {
    motions_[b] = bodies[b];
  }
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    const BodyRoller& roller = *rollers_[i].roller;
    const VesselPose& pose = motions_[rollers_[i].body].pose;
    placed_[i] = {pose.p_WV + pose.R_WV * roller.center_V,
                  pose.R_WV * roller.axis_V,
                  pose.R_WV * roller.normal_V,
                  roller.half_face,
                  roller.radius,
                  roller.law.stiffness};
  }
  rollers_moved_ = reference_.known ? rollers_moved() : 0.0;
}

/// Maximum motion of any end of a roller since the reference [m].
double RollerContacts::rollers_moved() const {
  double max_distance = 0.0;
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const PlacedRoller &current = placed_[i], &then = reference_.placed[i];
    max_distance = std::max(
        max_distance, (current.center - then.center).norm() + current.half_face * (current.axis - then.axis).norm());
  }
  return max_distance;
}

void RollerContacts::search(std::size_t body, const double* q, double reach) {
  const VesselPose& pose = motions_[body].pose;
  const Vec3 origin = pose.p_WV + pose.R_WV * (*bodies_)[body].ramp_origin_V;
  const Vec3 x_axis = -pose.R_WV.col(0), z_axis = pose.R_WV.col(2);
  const auto to_S = [&](const Vec3& v) { return Vec3(v.dot(x_axis), 0.0, v.dot(z_axis)); };
  const auto place_S = [&](int node) { return to_S(Vec3(Vec3Map(q + 6 * node)) - origin); };
  const std::vector<double>& length = line_->mesh.length;
  Vec3 r1 = place_S(0), t1 = to_S(Vec3Map(q + 3));
  for (std::size_t e = 0; e < length.size(); ++e) {
    const int node = static_cast<int>(e) + 1;
    const Vec3 r2 = place_S(node), t2 = to_S(Vec3Map(q + 6 * node + 3));
    bounds_[e] = make_element_bounds(r1, t1, r2, t2, length[e], reach);
    r1 = r2;
    t1 = t2;
  }
  search_cells((*bodies_)[body].cells, bounds_, ranges_[body]);
}

void RollerContacts::end_iteration(const std::vector<ContactMemory>& memories) {
  for (std::size_t i = 0; i < memories.size(); ++i) {
    iterate_[i] = {memories[i].axial, memories[i].lateral};
  }
}

/// Computes penetration and direction at the closest point found.
void RollerContacts::measure(std::size_t index, RollerDistance& distance, bool on_meant_side) {
  RollerContact& contact = contacts_[index];
  const std::size_t e = static_cast<std::size_t>(contact.closest.element);
  if (!on_meant_side && distance.value < 0.0) {
    turn_to_actual_side(distance);
  }
  contact.penetration = contact_radius(*line_, e, contact.closest.xi) + rollers_[index].roller->radius - distance.value;
  contact.normal_direction = distance.direction;
}

void RollerContacts::push(std::size_t index, const Eigen::Vector4d& shape, const ContactTarget& target) {
  const RollerContact& contact = contacts_[index];
  const Vec3 force = contact.force();
  add_point_force(target.residual.data() + 6 * contact.closest.element, shape, 0, 4, force);
  add_point_force(target.cuts.data() + 6 * contact.closest.element, shape, 2, 4, force);
  if (contact.closest.element == 0) {  // the cut at the first node is minus the contribution of the first element
    add_point_force(target.cuts.data(), shape, 0, 2, -force);
  }
}

void RollerContacts::evaluate(const double* q, const double* v, const Weights& weights,
                              const std::vector<ContactMemory>& before, std::vector<ContactMemory>& after,
                              ContactMode mode, const ContactTarget& target) {
  signature_ = 0xcbf29ce484222325ull;
  settled_ = mode == ContactMode::free;
  moved_ = reference_.known ? moved_since_reference(q) : kFar;
  looked_at_.clear();
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    passed_over_[i] = reference_.known && !before[i].carries && moved_ < reference_.gap[i];
    if (passed_over_[i]) {
      carrying_[i].carries = false;
      after[i] = apart(after[i]);
    } else {
      looked_at_.push_back(i);
    }
  }
  look(q, v, after);
  for (std::size_t k = 0; k < looked_at_.size(); ++k) {
    const std::size_t i = looked_at_[k];
    evaluate_one(i, meet(i, meetings_[k], q, v, after[i]), weights, before[i], after[i], mode, target);
  }
}

void RollerContacts::complete(const double* q, const double* v, std::vector<ContactMemory>& after) {
  looked_at_.clear();
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    if (passed_over_[i]) looked_at_.push_back(i);
    passed_over_[i] = false;
  }
  look(q, v, after);
  for (std::size_t k = 0; k < looked_at_.size(); ++k) {
    meet(looked_at_[k], meetings_[k], q, v, after[looked_at_[k]]);
  }
  moved_since_search_ += moved_;
  rollers_moved_ = 0.0;
  reference_.known = !rollers_.empty();
  std::copy_n(q, reference_.q.size(), reference_.q.begin());
  reference_.placed = placed_;
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    reference_.gap[i] = contacts_[i].closest.found ? -contacts_[i].penetration : 0.0;
    if (!contacts_[i].closest.found) measure_beyond_reach(i, q, v, after[i]);
  }
}

/// Upper bound, with a factor of two for variations of the thickness, of the change of any distance between line and
/// rollers since the reference [m].
double RollerContacts::moved_since_reference(const double* q) const {
  constexpr double kSure = 2.0;
  double place = 0.0, tangent = 0.0;
  for (int node = 0; node < line_->mesh.nodes(); ++node) {
    const double *current = q + 6 * node, *then = reference_.q.data() + 6 * node;
    const double dx = current[0] - then[0], dy = current[1] - then[1], dz = current[2] - then[2];
    const double tx = current[3] - then[3], ty = current[4] - then[4], tz = current[5] - then[5];
    place = std::max(place, dx * dx + dy * dy + dz * dz);
    tangent = std::max(tangent, tx * tx + ty * ty + tz * tz);
  }
  // The Bezier points of an element, whose hull contains it, move with its nodes and with a third of its length times
  // its tangents.
  return kSure * (std::sqrt(place) + max_length_ / 3.0 * std::sqrt(tangent) + rollers_moved_);
}

/// Finds the closest points of the line to the examined rollers if they are still in the previous elements.
void RollerContacts::look(const double* q, const double* v, const std::vector<ContactMemory>& memory) {
  looks_.clear();
  const int last = line_->mesh.elements() - 1;
  for (const std::size_t i : looked_at_) {
    const PlacedRoller& placed_roller = placed_[i];
    const int element = memory[i].element;
    const int passing = std::clamp(element + memory[i].passing, 0, last);
    looks_.push_back({placed_roller.center.data(), placed_roller.axis.data(), placed_roller.normal.data(),
                      placed_roller.half_face, memory[i].xi, element, passing});
  }
  find_closest_points({q, v, line_->mesh.length.data()}, looks_, meetings_, best_isa());
}

/// Finds the closest point of the line to a roller, from `seen` or else by a search along the line; contact.closest
/// states whether it passes the roller at all.
RollerContacts::Meeting RollerContacts::find(std::size_t index, const RollerClosestPoint& seen, const double* q,
                                             const double* v, const ContactMemory& memory) {
  using Map = Eigen::Map<const Vec3>;
  ClosestPoint& closest = contacts_[index].closest;
  const std::vector<double>& length = line_->mesh.length;
  const ElementRange reachable = within_reach(rollers_[index]);
  const ElementRange range =
      reachable.first < reachable.last ? reachable : ElementRange{0, static_cast<int>(length.size())};
  const auto within = [&](int element) { return range.first <= element && element < range.last; };
  if (seen.found && within(seen.element) && within(seen.passing)) {
    closest = {true,
               seen.element,
               seen.passing,
               seen.xi,
               Map(seen.place),
               Map(seen.tangent),
               Map(seen.reference),
               seen.beyond_face,
               seen.off_end};
    return {{seen.distance, Map(seen.direction)},
            Map(seen.velocity),
            Vec3::Zero(),
            Eigen::Map<const Eigen::Vector4d>(seen.shape)};
  }
  return search_along(index, range, q, v, memory);
}

/// Finds the closest point of the line among some elements, outwards from the previous one.
RollerContacts::Meeting RollerContacts::search_along(std::size_t index, const ElementRange& range, const double* q,
                                                     const double* v, const ContactMemory& memory) {
  ClosestPoint& closest = contacts_[index].closest;
  const std::vector<double>& length = line_->mesh.length;
  closest = closest_point_near(placed_[index], q, length.data(), range.first, range.last, memory.element, memory.xi);
  Meeting meeting;
  if (closest.found) {
    meeting.distance = roller_distance(placed_[index], closest);
    meeting.shape = hermite(closest.xi, length[static_cast<std::size_t>(closest.element)]).value;
    meeting.velocity = at_point(meeting.shape, element_unknowns(v, closest.element));
  }
  return meeting;
}

/// Sets distance and approach speed of the pipe at a roller that it passes.
void RollerContacts::regard(std::size_t index, Meeting& meeting) {
  RollerContact& contact = contacts_[index];
  measure(index, meeting.distance, false);
  const RigidMotion& body = motions_[rollers_[index].body];
  const double radius = line_->elements.radius[static_cast<std::size_t>(contact.closest.element)];
  const Vec3 arm = contact.closest.place - radius * meeting.distance.direction - body.pose.p_WV;
  contact.roller_velocity = body.velocity + body.omega.cross(arm);
  meeting.slip_rate = meeting.velocity - contact.roller_velocity;
  contact.rate = -meeting.slip_rate.dot(meeting.distance.direction);
}

/// Out-of-range roller: only the distance is computed.
void RollerContacts::measure_beyond_reach(std::size_t index, const double* q, const double* v,
                                          const ContactMemory& memory) {
  Meeting meeting = search_along(index, {0, line_->mesh.elements()}, q, v, memory);
  if (contacts_[index].closest.found) regard(index, meeting);
}

/// Returns the contact geometry of the pipe and a roller; empty if it does not pass it or is out of reach, where only
/// the distance matters.
std::optional<RollerContacts::Meeting> RollerContacts::meet(std::size_t index, const RollerClosestPoint& seen,
                                                            const double* q, const double* v, ContactMemory& after) {
  RollerContact& contact = contacts_[index];
  contact = RollerContact{};
  carrying_[index].carries = false;
  Meeting meeting = find(index, seen, q, v, after);
  after = apart(after);
  if (!contact.closest.found) {
    return std::nullopt;
  }
  after.element = contact.closest.element;
  after.xi = contact.closest.xi;
  after.passing = contact.closest.passing - contact.closest.element;
  regard(index, meeting);
  const ElementRange reachable = within_reach(rollers_[index]);
  if (reachable.first >= reachable.last) {
    return std::nullopt;
  }
  return meeting;
}

void RollerContacts::evaluate_one(std::size_t index, const std::optional<Meeting>& meeting, const Weights& weights,
                                  const ContactMemory& before, ContactMemory& after, ContactMode mode,
                                  const ContactTarget& target) {
  const BodyRoller& roller = *rollers_[index].roller;
  RollerContact& contact = contacts_[index];
  const bool kept = mode == ContactMode::kept;
  if (!meeting || (kept && !before.carries)) {
    return;
  }
  const NormalForce normal = kept ? attached_force(roller.law, contact.penetration, contact.rate)
                                  : normal_force(roller.law, contact.penetration, contact.rate);
  contact.normal = normal.force;
  if (normal.by_penetration <= 0.0) {
    return;
  }
  const Vec3& away = meeting->distance.direction;
  const Vec3& along = contact.closest.tangent;
  contact.axial_direction = (along - along.dot(away) * away).normalized();
  contact.lateral_direction = away.cross(contact.axial_direction);
  contact.slip_rate_axial = meeting->slip_rate.dot(contact.axial_direction);
  contact.slip_rate_lateral = meeting->slip_rate.dot(contact.lateral_direction);
  const auto friction = [&](double mu, double slip, double start_rate, double rate, Slip at_start, Slip last,
                            double full) {
    SlipStep step{slip, rate, weights.step, normal.force};
    if (before.carries) step.start_rate = start_rate;
    if (!continuation_.friction_by_slip) {
      return full == 0.0 ? FrictionForce{} : friction_in_state(roller.law, mu, step, slide(full));
    }
    if (kept) {
      return friction_in_state(roller.law, mu, step, at_start);
    }
    const FrictionForce force = friction_force(roller.law, mu, step);
    // a contact sticks between sliding in opposite directions
    if (static_cast<int>(force.state) * static_cast<int>(last) < 0) {
      settled_ = false;
      return friction_in_state(roller.law, mu, step, Slip::stick);
    }
    return force;
  };
  const FrictionForce axial =
      friction(roller.law.friction_axial, before.slip_axial, before.rate_axial, contact.slip_rate_axial, before.axial,
               iterate_[index].axial, continuation_.roller_friction.along);
  const FrictionForce lateral = friction(roller.law.friction_lateral, before.slip_lateral, before.rate_lateral,
                                         contact.slip_rate_lateral, before.lateral, iterate_[index].lateral, 0.0);
  contact.axial = axial.force;
  contact.lateral = lateral.force;
  after = {axial.slip,
           lateral.slip,
           true,
           axial.state,
           lateral.state,
           after.element,
           after.xi,
           after.passing,
           contact.slip_rate_axial,
           contact.slip_rate_lateral};
  signature_ =
      mixed(signature_, 16 * index + (axial.state == Slip::stick ? 0u : 1u) + (lateral.state == Slip::stick ? 0u : 2u));
  push(index, meeting->shape, target);
  carrying_[index] = {true, meeting->distance, normal, axial, lateral};
}

int RollerContacts::first_within_reach(int beyond) const {
  int first = beyond;
  for (const std::vector<ElementRange>& of_body : ranges_) {
    for (const ElementRange& range : of_body) {
      first = range.first < range.last ? std::min(first, range.first) : first;
    }
  }
  return first;
}

int RollerContacts::first_carrying(int beyond) const {
  int first = beyond;
  for (std::size_t i = 0; i < carrying_.size(); ++i) {
    first = carrying_[i].carries ? std::min(first, contacts_[i].closest.element) : first;
  }
  return first;
}

}  // namespace overbend
