#include "statics/line_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overbend {
namespace {

using Vec3Map = Eigen::Map<const Vec3>;

Vec3 position(const std::vector<double>& q, int node) {
  return Vec3(Vec3Map(q.data() + 6 * node));
}
Vec3 tangent_at(const std::vector<double>& q, int node) {
  return Vec3(Vec3Map(q.data() + 6 * node + 3));
}

ElementVector dofs_of(const std::vector<double>& q, int element) {
  return ElementVector(Eigen::Map<const ElementVector>(q.data() + 6 * element));
}

/// Bounds in S of the Bezier hull of an element.
ElementBounds element_bounds(const Vec3& r1_S, const Vec3& t1_S, const Vec3& r2_S, const Vec3& t2_S, double h) {
  const Vec3 b1 = r1_S + h / 3.0 * t1_S;
  const Vec3 b2 = r2_S - h / 3.0 * t2_S;
  return {std::min({r1_S.x(), r2_S.x(), b1.x(), b2.x()}), std::max({r1_S.x(), r2_S.x(), b1.x(), b2.x()}),
          std::min({r1_S.z(), r2_S.z(), b1.z(), b2.z()})};
}

}  // namespace

double penalty_stiffness(const Section& pipe, double element_length) {
  return pipe.EI / std::pow(std::max(element_length, pipe.steel_diameter), 3);
}

void advance(LineState& to, const LineState& from, const std::vector<double>& dq, double share) {
  to.q.resize(dq.size());
  to.low.resize(dq.size());
  for (std::size_t i = 0; i < dq.size(); ++i) {
    const double step = share * dq[i] + (from.low.empty() ? 0.0 : from.low[i]);
    const double sum = from.q[i] + step;
    const double part = sum - from.q[i];
    to.low[i] = (from.q[i] - (sum - part)) + (step - part);
    to.q[i] = sum;
  }
}

LineSystem::LineSystem(const Model& model, const VesselPose& pose, LineMesh mesh)
    : model_(&model), mesh_(std::move(mesh)), plane_(lay_plane(model, pose)), pose_(pose) {
  elements_ = line_elements(model, mesh_.length, mesh_.section);
  environment_ = line_environment(model, plane_.tensioner_W, plane_.port_W);
  yielding_ = yielding_elements(model, mesh_);
  double radius = 0.0;
  for (std::size_t e = 0; e < mesh_.length.size(); ++e) {
    total_weight_ += elements_.weight[e] * mesh_.length[e];
    radius = std::max(radius, elements_.radius[e]);
  }
  cells_ = contact_cells(model.supports, radius);
  place_rollers(pose);
  hold_ends();

  const std::size_t nodes = static_cast<std::size_t>(mesh_.nodes());
  residual_.resize(6 * nodes);
  tangent_.resize(mesh_.nodes());
  bounds_.resize(nodes - 1);
  ranges_.resize(cells_.boxes.size());
  roller_states_.resize(rollers_.size());
}

void LineSystem::place_rollers(const VesselPose& pose) {
  const double over_supports = *std::min_element(mesh_.length.begin(), mesh_.length.end());
  for (const Roller& roller : model_->supports.rollers) {
    PlacedRoller placed;
    placed.center = point_from_ramp(*model_, pose, roller.center_S);
    placed.axis = direction_from_ramp(pose, roller.axis_S);
    placed.normal = direction_from_ramp(pose, roller.normal_S);
    placed.half_face = 0.5 * roller.face;
    placed.radius = roller.radius;
    placed.stiffness =
        roller.stiffness > 0.0 ? roller.stiffness : penalty_stiffness(model_->section_over(roller), over_supports);
    rollers_.push_back(placed);
    roller_box_.push_back(roller.box);
  }
}

void LineSystem::limit_bed_stiffness(double limit) {
  environment_.bed_stiffness = environment_.bed_stick = std::min(model_->seabed.stiffness, limit);
}

void LineSystem::hold_ends() {
  const Vec3 up = model_->seabed.normal_W;
  far_direction_ = (plane_.astern_W - plane_.astern_W.dot(up) * up).normalized();
  held_far_.position = {{plane_.port_W, Vec3::Zero(), Vec3::Zero()}, 1};
  held_far_.tangent = across(far_direction_);
  held_top_.position = all_directions();
  if (model_->description.tensioner.guide == Guide::clamped) {
    const double incline = model_->description.tensioner.incline;
    held_top_.tangent = across(direction_from_ramp(pose_, Vec3(std::cos(incline), 0.0, -std::sin(incline))));
  }
}

void LineSystem::evaluate(const LineState& state, bool with_tangent) {
  std::fill(residual_.begin(), residual_.end(), 0.0);
  if (with_tangent) {
    tangent_.set_zero();
  }
  LineTarget target{residual_.data(), nullptr, nullptr, nullptr};
  if (with_tangent) {
    target = {residual_.data(), tangent_.diag(0), tangent_.upper(0), tangent_.lower(0)};
  }
  add_line_forces(elements_, environment_, state.shape(), target, best_isa());
  add_yielding(state, with_tangent, false);
  for (int i = 0; i < 3; ++i) {
    residual_[static_cast<std::size_t>(i)] -= state.far_force * far_direction_(i);
  }
  find_contacts(state);
  add_contacts(state, with_tangent);
}

void LineSystem::add_yielding(const LineState& state, bool with_tangent, bool keep_memory) {
  if (!remembers()) {
    return;
  }
  choose_levels(yielding_, state.q.data());
  add_static_yielding(yielding_, mesh_, {model_->description.statics.history, yield_share_}, state.shape(), keep_memory,
                      yielding_points_, {&residual_, with_tangent ? &tangent_ : nullptr});
}

std::vector<BendingMemory> LineSystem::bending_memory(const LineState& state) {
  add_yielding(state, false, true);
  return yielding_points_.memory;
}

void LineSystem::find_contacts(const LineState& state) {
  if (rollers_.empty()) {
    return;
  }
  const Vec3 origin = point_from_ramp(*model_, pose_, Vec3::Zero());
  const Vec3 x_axis = direction_from_ramp(pose_, Vec3::UnitX());
  const Vec3 z_axis = direction_from_ramp(pose_, Vec3::UnitZ());
  const auto to_S = [&](const Vec3& v) { return Vec3(v.dot(x_axis), 0.0, v.dot(z_axis)); };
  Vec3 r1 = to_S(position(state.q, 0) - origin), t1 = to_S(tangent_at(state.q, 0));
  for (std::size_t e = 0; e < mesh_.length.size(); ++e) {
    const int node = static_cast<int>(e) + 1;
    const Vec3 r2 = to_S(position(state.q, node) - origin), t2 = to_S(tangent_at(state.q, node));
    bounds_[e] = element_bounds(r1, t1, r2, t2, mesh_.length[e]);
    r1 = r2;
    t1 = t2;
  }
  search_cells(cells_, bounds_, ranges_);
}

void LineSystem::add_contacts(const LineState& state, bool with_tangent) {
  for (std::size_t i = 0; i < rollers_.size(); ++i) {
    const PlacedRoller& roller = rollers_[i];
    RollerState& contact = roller_states_[i];
    contact = RollerState{};
    if (!use_side_rollers_ && model_->supports.rollers[i].position != RollerPosition::bottom) {
      continue;
    }
    const ElementRange range = ranges_[static_cast<std::size_t>(roller_box_[i])];
    contact.at = closest_point(roller, state.q.data(), mesh_.length.data(), range.first, range.last);
    if (!contact.at.found) {
      continue;
    }
    const std::size_t e = static_cast<std::size_t>(contact.at.element);
    const double h = mesh_.length[e];
    const ElementVector q = dofs_of(state.q, contact.at.element);
    const RollerDistance distance = roller_distance(roller, contact.at, q, h);
    contact.direction = distance.direction;
    contact.penetration = elements_.radius[e] + roller.radius - distance.value;
    if (contact.penetration <= 0.0) {
      continue;
    }
    const double stiffness = std::min(roller.stiffness, roller_limit_);
    contact.force = stiffness * contact.penetration;
    const RollerDistanceDerivatives d = roller_distance_derivatives(roller, contact.at, distance, q, h);
    const int node = contact.at.element;
    for (int k = 0; k < 12; ++k) {
      residual_[static_cast<std::size_t>(6 * node + k)] -= contact.force * d.gradient(k);
    }
    if (with_tangent) {
      const ElementMatrix k = stiffness * d.gradient * d.gradient.transpose() - contact.force * d.hessian;
      add_element(tangent_, node, k);
    }
  }
}

Vec3 LineSystem::end_reaction(int node) const {
  return Vec3(Vec3Map(residual_.data() + 6 * node));
}

void LineSystem::hold(bool with_blocks) {
  BlockTridiagonal* blocks = with_blocks ? &tangent_ : nullptr;
  hold_node(0, held_far_, residual_, blocks);
  hold_node(mesh_.nodes() - 1, held_top_, residual_, blocks);
}

double LineSystem::relative_residual() const {
  double worst = 0.0;
  for (std::size_t node = 0; node < mesh_.s.size(); ++node) {
    const std::size_t left = node == 0 ? 0 : node - 1;
    const std::size_t right = std::min(node, mesh_.length.size() - 1);
    const double h = std::min(mesh_.length[left], mesh_.length[right]);
    const double* r = residual_.data() + 6 * node;
    const double force = std::max(Vec3Map(r).norm(), Vec3Map(r + 3).norm() / h);
    if (!(force < std::numeric_limits<double>::infinity())) {  // a maximum would pass over what is not a number
      return std::numeric_limits<double>::infinity();
    }
    worst = std::max(worst, force);
  }
  return worst / total_weight_;
}

double LineSystem::target_error(const LineState& state, const LineTargetValue& target) const {
  if (target.kind == LineTargetValue::Kind::anchor_distance) {
    return (position(state.q, 0) - plane_.tensioner_W).dot(plane_.astern_W) - target.value;
  }
  const int last = mesh_.nodes() - 1;
  const std::size_t e = mesh_.length.size() - 1;
  const double z = position(state.q, last).z();
  const double pressure = elements_.pressure_constant[e] + elements_.pressure_slope[e] * z +
                          elements_.pressure_external[e] * std::max(-z, 0.0);
  return elements_.EA[e] * (tangent_at(state.q, last).norm() - 1.0) + pressure - target.value;
}

bool LineSystem::solve_step(const LineState& state, const LineTargetValue& target, double damping, bool free_far_force,
                            std::vector<double>& dq, double& dH) {
  const int n = mesh_.nodes();
  for (int node = 0; node < n; ++node) {
    for (int i = 0; i < kNodeDofs; ++i) {
      tangent_.rhs(node, i, 0) = -residual_[static_cast<std::size_t>(6 * node + i)];
    }
    if (damping > 0.0) {
      const double h = mesh_.length[static_cast<std::size_t>(std::min(node, n - 2))];
      for (int i = 0; i < kNodeDofs; ++i) {
        tangent_.diag(node)[i * kRowWidth + i] += damping * h * (i < 3 ? 1.0 : h * h / 12.0);
      }
    }
  }
  Vec3 border = far_direction_;  // K dq - far_direction dH = -R at the far end
  for (const Vec3& d : held_far_.position) {
    border -= border.dot(d) * d;
  }
  for (int i = 0; i < 3; ++i) {
    tangent_.rhs(0, i, 1) = border(i);
  }
  solve_report_ = solve(tangent_);
  if (!solve_report_.solved()) {
    return false;
  }
  const bool anchor = target.kind == LineTargetValue::Kind::anchor_distance;
  const int at = anchor ? 0 : n - 1;
  const Vec3 gradient =
      anchor ? plane_.astern_W : Vec3(elements_.EA[mesh_.length.size() - 1] * tangent_at(state.q, at).normalized());
  double along_residual = 0.0, along_border = 0.0;
  for (int i = 0; i < 3; ++i) {
    along_residual += gradient(i) * tangent_.rhs(at, anchor ? i : 3 + i, 0);
    along_border += gradient(i) * tangent_.rhs(at, anchor ? i : 3 + i, 1);
  }
  dH = free_far_force ? (-target_error(state, target) - along_residual) / along_border : 0.0;
  if (!std::isfinite(dH)) {
    solve_report_.singular_node = at;
    return false;
  }
  for (int node = 0; node < n; ++node) {
    for (int i = 0; i < kNodeDofs; ++i) {
      dq[static_cast<std::size_t>(6 * node + i)] = tangent_.rhs(node, i, 0) + dH * tangent_.rhs(node, i, 1);
    }
  }
  return true;
}

double LineSystem::share_before_entering(const std::vector<double>& dq, double depth) const {
  double share = 1.0;
  for (const RollerState& contact : roller_states_) {
    if (!contact.at.found) {
      continue;
    }
    const ElementVector step = dofs_of(dq, contact.at.element);
    const double h = mesh_.length[static_cast<std::size_t>(contact.at.element)];
    const double deeper = -contact.direction.dot(centreline(step, contact.at.xi, h).r);
    const double allowed = depth + std::max(-contact.penetration, 0.0);
    share = deeper > allowed ? std::min(share, allowed / deeper) : share;
  }
  return share;
}

double LineSystem::work(const std::vector<double>& dq) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < dq.size(); ++i) {
    sum += residual_[i] * dq[i];
  }
  return sum;
}

}  // namespace overbend
