#include "system/body_border.h"

#include <algorithm>
#include <cmath>

#include "system/held_end.h"

namespace overbend {
namespace {

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

ElementVector element_unknowns(const std::vector<double>& values, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(values.data() + 6 * element));
}

bool touches(const System& system, std::size_t line, int body) {
  const bool held = std::any_of(system.attachments.begin(), system.attachments.end(), [&](const Attachment& a) {
    return to_size(a.line) == line && a.body == body && (a.hold_place || a.hold_direction);
  });
  return held || (system.lines[line].on_rollers && !system.bodies[to_size(body)].rollers.empty());
}

/// True if a line touches another body that this body carries, directly or indirectly, on a hinge.
bool touches_carried_body(const System& system, std::size_t line, int body) {
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    const std::optional<FreeBody>& free = system.bodies[i].free;
    if (free && free->hinge && free->hinge->carrier == body &&
        (touches(system, line, static_cast<int>(i)) || touches_carried_body(system, line, static_cast<int>(i)))) {
      return true;
    }
  }
  return false;
}

/// Numbers of the free bodies by body index, -1 for other bodies.
std::vector<int> free_numbers(const System& system) {
  std::vector<int> numbers(system.bodies.size(), -1);
  int next = 0;
  for (const int index : free_bodies(system)) {
    numbers[to_size(index)] = next++;
  }
  return numbers;
}

}  // namespace

std::vector<int> free_bodies(const System& system) {
  std::vector<int> free;
  for (std::size_t i = 0; i < system.bodies.size(); ++i) {
    if (system.bodies[i].free) {
      free.push_back(static_cast<int>(i));
    }
  }
  return free;
}

BodyBorder::BodyBorder(const System& system)
    : system_(&system), number_(free_numbers(system)), hinged_(system, number_) {
  for (const int index : free_bodies(system)) {
    bodies_.push_back({&*system.bodies[to_size(index)].free, index, {}, {}, {}});
  }
  residual_.assign(to_size(unknowns()), 0.0);
  for (std::size_t line = 0; line < system.lines.size(); ++line) {
    LinePart part;
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      if (touches(system, line, bodies_[k].index) || touches_carried_body(system, line, bodies_[k].index)) {
        part.bodies.push_back(static_cast<int>(k));
      }
    }
    part.corner.assign(to_size(part.unknowns() * part.unknowns()), 0.0);
    lines_.push_back(std::move(part));
  }
  for (const Wire& wire : system.wires) {
    wire_ends_.push_back({WireEnd{free_body_number(wire.first_body)}, WireEnd{free_body_number(wire.second_body)}});
  }
  wires_.resize(system.wires.size());
}

std::vector<BorderedLine> BodyBorder::lines() const {
  std::vector<BorderedLine> lines;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    BorderedLine line{system_->lines[i].mesh.nodes(), {}};
    for (const int body : lines_[i].bodies) {
      for (int k = 0; k < 6; ++k) {
        line.unknowns.push_back(6 * body + k);
      }
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

BodyBorder::Place BodyBorder::border_place(int line, int number) const {
  const std::vector<int>& bodies = lines_[to_size(line)].bodies;
  const auto found = std::find(bodies.begin(), bodies.end(), number);
  return {line, 6 * static_cast<int>(found - bodies.begin()), &bodies_[to_size(number)].pose};
}

void BodyBorder::lead(const std::vector<HullState>& states, Surroundings& surroundings) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (!bodies_[k].body->hinge) {
      bodies_[k].pose = make_pose(states[k].h);
      surroundings.bodies[to_size(bodies_[k].index)] = rigid_motion(*bodies_[k].body, states[k]);
    }
  }
  if (!hinged_.empty()) {
    hinged_.lead(states, surroundings);
  }
  for (std::size_t i = 0; i < system_->attachments.size(); ++i) {
    const Attachment& attachment = system_->attachments[i];
    if (free_body_number(attachment.body) >= 0) {
      surroundings.ends[i] =
          attached_to(surroundings.bodies[to_size(attachment.body)], attachment.place, attachment.direction);
    }
  }
  set_wire_ends(surroundings);
}

void BodyBorder::set_wire_ends(const Surroundings& surroundings) {
  const auto place = [&](int body, const Vec3& point) {
    return body == kGround ? point : point_motion(surroundings.bodies[to_size(body)], point).place;
  };
  for (std::size_t i = 0; i < wire_ends_.size(); ++i) {
    const Wire& wire = system_->wires[i];
    wire_ends_[i][0].place = place(wire.first_body, wire.first);
    wire_ends_[i][1].place = place(wire.second_body, wire.second);
  }
}

void BodyBorder::add_wire_forces() {
  for (std::size_t i = 0; i < wires_.size(); ++i) {
    const std::array<WireEnd, 2>& ends = wire_ends_[i];
    wires_[i] = wire_pull(system_->wires[i], ends[0].place, ends[1].place);
    for (std::size_t end = 0; end < 2; ++end) {
      if (ends[end].number < 0) continue;
      const BodyPose& pose = bodies_[to_size(ends[end].number)].pose;
      const Vec3 force = end == 0 ? wires_[i].force : Vec3(-wires_[i].force);
      Eigen::Map<Vec6>(residual_.data() + 6 * ends[end].number) -=
          generalised_force(pose, ends[end].place - pose.place, force);
    }
  }
}

/// A spring on each of its bodies, coupled by their positions.
void BodyBorder::put_wires(BorderedSystem& solver) const {
  for (std::size_t i = 0; i < wires_.size(); ++i) {
    if (wires_[i].tension <= 0.0) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      const WireEnd& this_end = wire_ends_[i][end];
      if (this_end.number < 0) continue;
      const BodyPose& pose = bodies_[to_size(this_end.number)].pose;
      const Mat36 rows = point_rows(pose, this_end.place);
      const Vec3 force = end == 0 ? wires_[i].force : Vec3(-wires_[i].force);
      const auto add = [&](int number, const Mat6& part) {
        for (int r = 0; r < 6; ++r) {
          for (int c = 0; c < 6; ++c) solver.corner(6 * this_end.number + r, 6 * number + c) += part(r, c);
        }
      };
      add(this_end.number, rows.transpose() * wires_[i].stiffness * rows -
                               generalised_force_slope(pose, this_end.place - pose.place, force));
      const WireEnd& opposite = wire_ends_[i][1 - end];
      if (opposite.number < 0) continue;
      const Mat36 others = point_rows(bodies_[to_size(opposite.number)].pose, opposite.place);
      add(opposite.number, -rows.transpose() * wires_[i].stiffness * others);
    }
  }
}

void BodyBorder::begin_step() {
  for (Member& member : bodies_) member.own_balance.surroundings.reset();
}

void BodyBorder::add_contact_forces(const LineAssembly& line) {
  const RollerContacts& contacts = line.contacts();
  for (int i = 0; i < contacts.count(); ++i) {
    const int number = free_body_number(contacts.roller_body(i));
    if (number >= 0 && contacts.carries(i)) {
      const RollerContact& contact = contacts.contacts()[to_size(i)];
      if (hinged_.has(number)) {
        hinged_.add_roller(number, contact.closest.place, contact.force(), residual_);
        continue;
      }
      const BodyPose& pose = bodies_[to_size(number)].pose;
      Eigen::Map<Vec6>(residual_.data() + 6 * number) +=
          generalised_force(pose, contact.closest.place - pose.place, contact.force());
    }
  }
}

void BodyBorder::add_end_force(const Attachment& held, const LineAssembly& line, const LineState& state) {
  const int number = free_body_number(held.body);
  Eigen::Map<Vec6>(residual_.data() + 6 * number) += held_end_force(held, line, state, bodies_[to_size(number)].pose);
}

double BodyBorder::end_power(const Attachment& held, const LineAssembly& line, const SystemState& state) const {
  const std::size_t number = to_size(free_body_number(held.body));
  return held_end_force(held, line, state.lines[to_size(held.line)], bodies_[number].pose).dot(state.bodies[number].v);
}

void BodyBorder::evaluate(SystemState& state, const SystemState& before, const Weights& weights,
                          const std::vector<LineAssembly>& lines, bool with_tangent) {
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    Member& member = bodies_[k];
    if (member.body->hinge) {
      Eigen::Map<Vec6>(residual_.data() + 6 * k).setZero();
      continue;
    }
    member.body->balance(state.bodies[k], before.bodies[k], weights, state.time, member.own_balance);
    add_springs(*member.body, before.bodies[k], state.time, state.bodies[k], member.own_balance);
    Eigen::Map<Vec6>(residual_.data() + 6 * k) = member.own_balance.residual;
  }
  if (!hinged_.empty()) {
    hinged_.evaluate(state.bodies, before.bodies, weights, with_tangent, residual_);
  }
  add_wire_forces();
  for (const LineAssembly& line : lines) {
    add_contact_forces(line);
  }
  for (const Attachment& held : system_->attachments) {
    if (free_body_number(held.body) >= 0) {
      add_end_force(held, lines[to_size(held.line)], state.lines[to_size(held.line)]);
    }
  }
}

void BodyBorder::add_corner(const Place& place, const Mat6& part) {
  LinePart& line = lines_[to_size(place.line)];
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      line.corner[to_size((place.first + i) * line.unknowns() + place.first + j)] += part(i, j);
    }
  }
}

void BodyBorder::put_contacts(int index, const LineAssembly& line, const LineState& state, const Weights& weights,
                              BorderedSystem& solver) {
  const RollerContacts& contacts = line.contacts();
  for (int i = 0; i < contacts.count(); ++i) {
    const int number = free_body_number(contacts.roller_body(i));
    if (number < 0 || !contacts.carries(i)) {
      continue;
    }
    if (hinged_.has(number)) {
      put_hinged_contact(index, number, i, line, state, weights, solver);
      continue;
    }
    const Place place = border_place(index, number);
    const int node = contacts.contacts()[to_size(i)].closest.element;
    const ContactBorder border =
        contact_border(*place.pose, element_unknowns(state.q, node), contacts.contact_residual(i),
                       contacts.contact_tangent(i, state.q.data(), weights), contacts.contact_turning(i, weights));
    for (int half = 0; half < 2; ++half) {
      add_to_panel(solver.columns(index, node + half), solver.stride(index), place.first,
                   border.columns.middleRows<6>(6 * half));
      add_to_panel(solver.rows(index, node + half), solver.stride(index), place.first,
                   border.rows.middleRows<6>(6 * half));
    }
    add_corner(place, border.corner);
  }
}

/// Like a body with six unknowns, but for each motion that carries the roller: of the hinges and, if free, of the
/// vessel. The motion of a hinge's position and axis with its carrier enters the corner.
void BodyBorder::put_hinged_contact(int index, int number, int roller, const LineAssembly& line, const LineState& state,
                                    const Weights& weights, BorderedSystem& solver) {
  const RollerContacts& contacts = line.contacts();
  const int node = contacts.contacts()[to_size(roller)].closest.element;
  const ElementVector q = element_unknowns(state.q, node), residual = contacts.contact_residual(roller);
  const ElementMatrix tangent = contacts.contact_tangent(roller, state.q.data(), weights);
  const Eigen::Matrix<double, 12, 3> turning = contacts.contact_turning(roller, weights);
  const int vessel = hinged_.vessel();
  LinePart& part = lines_[to_size(index)];
  const int width = part.unknowns();
  const auto panel = [&](int half, int column, bool of_rows) {
    return (of_rows ? solver.rows(index, node + half) : solver.columns(index, node + half)) + column;
  };
  const auto corner = [&](int row, int column) -> double& { return part.corner[to_size(row * width + column)]; };
  const auto hinge_column = [&](int turned) { return border_place(index, turned).first + kHingeFreedom; };
  for (const int turned : hinged_.chain(number)) {
    const Twist& twist = hinged_.twist(turned);
    const TwistBorder by = twist_border(twist, q, residual, tangent, turning);
    const int column = hinge_column(turned);
    for (int k = 0; k < 12; ++k) {
      panel(k / 6, column, false)[(k % 6) * solver.stride(index)] += by.column(k);
      panel(k / 6, column, true)[(k % 6) * solver.stride(index)] += by.row(k);
    }
    const CarrierMotion motion{Vec3::Zero(), twist.axis, twist.origin};
    for (const int ancestor : hinged_.chain(number)) {
      const bool carries = turned < ancestor;  // numbers increase astern
      corner(hinge_column(ancestor), column) +=
          twist_corner(hinged_.twist(ancestor), carries ? &motion : nullptr, q, residual, by.column);
    }
    for (int k = 0; k < (vessel < 0 ? 0 : 6); ++k) {
      corner(border_place(index, vessel).first + k, column) -=
          element_motion(carrier_motion(bodies_[to_size(vessel)].pose, k), q).dot(by.column);
    }
  }
  if (vessel < 0) {
    return;
  }
  const Place place = border_place(index, vessel);
  const ContactBorder border = contact_border(*place.pose, q, residual, tangent, turning);
  for (int half = 0; half < 2; ++half) {
    add_to_panel(panel(half, 0, false), solver.stride(index), place.first, border.columns.middleRows<6>(6 * half));
    add_to_panel(panel(half, 0, true), solver.stride(index), place.first, border.rows.middleRows<6>(6 * half));
  }
  add_corner(place, border.corner);
  for (const int ancestor : hinged_.chain(number)) {
    for (int k = 0; k < 6; ++k) {
      const CarrierMotion motion = carrier_motion(*place.pose, k);
      corner(hinge_column(ancestor), place.first + k) +=
          twist_corner(hinged_.twist(ancestor), &motion, q, residual, border.columns.col(k));
    }
  }
}

/// The held unknowns of the node follow the body by E = HeldEnd::motion: their columns and rows, including those from
/// contacts, are added to the body's.
void BodyBorder::put_end(const Attachment& held, const LineAssembly& line, const LineState& state,
                         BorderedSystem& solver) {
  const int index = held.line, stride = solver.stride(index);
  const Place place = border_place(index, free_body_number(held.body));
  const HeldEnd end = held_end(held, line, state, *place.pose);
  const Mat6 node_block = diagonal_block(line, end.node);
  const bool met = solver.bordered(index, end.node);  // by contacts, or at the line's opposite end
  double* const columns = solver.columns(index, end.node);
  double* const rows = solver.rows(index, end.node);
  LinePart& part = lines_[to_size(index)];
  for (int j = 0; j < (met ? part.unknowns() : 0); ++j) {
    for (int i = 0; i < 6; ++i) {
      for (int dof = 0; dof < 6; ++dof) {
        const double moved = end.motion(dof, i);
        part.corner[to_size((place.first + i) * part.unknowns() + j)] += moved * columns[dof * stride + j];
        part.corner[to_size(j * part.unknowns() + place.first + i)] += moved * rows[dof * stride + j];
      }
    }
  }
  add_corner(place, end.motion.transpose() * node_block * end.motion + end.turning);
  add_to_panel(columns, stride, place.first, node_block * end.motion + end.turned_force);
  add_to_panel(rows, stride, place.first, node_block.transpose() * end.motion + end.turned_force);
  const auto add_neighbour = [&](const NeighbourBlocks& blocks) {
    add_to_panel(solver.columns(index, blocks.neighbour), stride, place.first, blocks.to_own * end.motion);
    add_to_panel(solver.rows(index, blocks.neighbour), stride, place.first, blocks.from_own.transpose() * end.motion);
  };
  if (end.node > 0) add_neighbour(blocks_before(line, end.node));
  if (end.node < line.line().mesh.nodes() - 1) add_neighbour(blocks_behind(line, end.node));
}

void BodyBorder::put_line(int index, const LineAssembly& line, const SystemState& state, const Weights& weights,
                          const std::vector<HeldDirections>& held, BorderedSystem& solver) {
  LinePart& part = lines_[to_size(index)];
  if (part.bodies.empty()) {
    return;
  }
  solver.clear_border(index);
  std::fill(part.corner.begin(), part.corner.end(), 0.0);
  put_contacts(index, line, state.lines[to_size(index)], weights, solver);
  for (const Attachment& attachment : system_->attachments) {
    if (attachment.line == index && free_body_number(attachment.body) >= 0) {
      put_end(attachment, line, state.lines[to_size(index)], solver);
    }
  }
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int node = held_node(system_->attachments[i], line.line());
    if (system_->attachments[i].line == index && solver.bordered(index, node)) {
      remove_held(held[i], solver.columns(index, node), solver.stride(index));
      remove_held(held[i], solver.rows(index, node), solver.stride(index));
    }
  }
}

void BodyBorder::put_corner(BorderedSystem& solver) const {
  solver.clear_corner();
  for (int i = 0; i < (hinged_.empty() ? 0 : unknowns()); ++i) {
    for (int j = 0; j < unknowns(); ++j) {
      solver.corner(i, j) = hinged_.tangent()[to_size(i * unknowns() + j)];
    }
  }
  for (std::size_t k = 0; k < bodies_.size(); ++k) {
    if (bodies_[k].body->hinge) continue;
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        solver.corner(6 * static_cast<int>(k) + i, 6 * static_cast<int>(k) + j) += bodies_[k].own_balance.tangent(i, j);
      }
    }
  }
  put_wires(solver);
  for (const LinePart& part : lines_) {
    const int m = part.unknowns();
    for (int i = 0; i < m; ++i) {
      for (int j = 0; j < m; ++j) {
        solver.corner(6 * part.bodies[to_size(i / 6)] + i % 6, 6 * part.bodies[to_size(j / 6)] + j % 6) +=
            part.corner[to_size(i * m + j)];
      }
    }
  }
}

bool BodyBorder::holds_before_last(int line) const {
  return std::any_of(system_->attachments.begin(), system_->attachments.end(), [&](const Attachment& a) {
    return a.line == line && a.end != LineEnd::last && free_body_number(a.body) >= 0;
  });
}

void BodyBorder::hold(int body, int freedom, bool held) {
  bodies_[to_size(free_body_number(body))].held[to_size(freedom)] = held;
}

bool BodyBorder::held(int body, int freedom) const {
  return bodies_[to_size(free_body_number(body))].held[to_size(freedom)];
}

double BodyBorder::relative_residual(std::size_t number) const {
  const Member& member = bodies_[number];
  double force = 0.0, moment = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double f = member.held[i] ? 0.0 : residual_[6 * number + i];
    const double m = member.held[i + 3] ? 0.0 : residual_[6 * number + 3 + i] / member.body->arm;
    force += f * f;
    moment += m * m;
  }
  return std::sqrt(std::max(force, moment)) / member.body->force_scale;
}

}  // namespace overbend
