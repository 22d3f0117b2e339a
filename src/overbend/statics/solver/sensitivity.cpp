#include "statics/solver/sensitivity.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "mechanics/rod_element.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/solver/starting_point.h"

namespace overbend {
namespace {

constexpr double kDifferenceStep = 1e-5;        ///< Maximum nodal displacement of tangent differences [m].
constexpr double kTolerance = 1e-7;             ///< Remaining share of an imbalance if the tangent is inexact.
constexpr int kMaxDirections = 25;              ///< Maximum number of directions evaluated per imbalance.
constexpr std::size_t kMaxKeptDirections = 40;  ///< Maximum number of these kept for other inputs.

Vec3 tangent_at(const std::vector<double>& q, int node) {
  return Vec3(Eigen::Map<const Vec3>(q.data() + 6 * node + 3));
}

/// Change of a position or direction when the heading turns from one horizontal unit vector to another.
Vec3 turned(const Vec3& from, const Vec3& to, const Vec3& d) {
  const double sine = from.cross(to).z(), back = sine * sine / (1.0 + from.dot(to));
  return {-back * d.x() - sine * d.y(), sine * d.x() - back * d.y(), 0.0};
}

/// Displacement of the unknowns of a state that puts its ends where `to` holds them. The line moves as a whole with the
/// tensioner and its heading; in height each node moves by its share, so that nothing is stretched sharply. The choice
/// of nodal displacements does not affect the result.
std::vector<double> displacement_to_ends(const StaticSystem& from, const StaticSystem& to, const LineState& state) {
  const LayPlane &old_plane = from.plane(), &plane = to.plane();
  const Vec3 top = plane.tensioner_W - old_plane.tensioner_W;
  const Vec3 level(top.x(), top.y(), 0.0);
  const auto turn = [&](const Vec3& d) { return turned(old_plane.astern_W, plane.astern_W, d); };
  const auto with_vessel = [&](const Vec3& place) { return Vec3(level + turn(place - old_plane.tensioner_W)); };
  const Vec3 far = Eigen::Map<const Vec3>(state.q.data());
  const double far_across = old_plane.route.offset(far) - plane.route.offset(far + with_vessel(far));
  const bool pinned = cable_at_far_end(from.model().description);
  const double lift = pinned ? pinned_height(to.model()) - pinned_height(from.model()) : 0.0;
  const Vec3 far_way = far_across * plane.port_W + lift * Vec3::UnitZ();
  const LineMesh& mesh = from.mesh();
  std::vector<double> mode(state.q.size(), 0.0);
  for (int node = 0; node < mesh.nodes(); ++node) {
    const double share = mesh.s[static_cast<std::size_t>(node)] / mesh.total_length();
    const Vec3 place = Eigen::Map<const Vec3>(state.q.data() + 6 * node);
    Eigen::Map<Vec3>(mode.data() + 6 * node) =
        with_vessel(place) + share * top.z() * Vec3::UnitZ() + (1.0 - share) * far_way;
    Eigen::Map<Vec3>(mode.data() + 6 * node + 3) = turn(tangent_at(state.q, node));
  }
  const int last = mesh.nodes() - 1;
  Eigen::Map<Vec3>(mode.data() + 6 * last) = top;
  if (!pinned) {
    Eigen::Map<Vec3>(mode.data() + 3) =
        tangent_at(state.q, 0).dot(from.far_direction()) * (to.far_direction() - from.far_direction());
  }
  if (from.held_direction() && to.held_direction()) {
    Eigen::Map<Vec3>(mode.data() + 6 * last + 3) =
        tangent_at(state.q, last).dot(*from.held_direction()) * (*to.held_direction() - *from.held_direction());
  }
  return mode;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add(std::vector<double>& a, double factor, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Half the difference.
double half(double before, double after) {
  return 0.5 * (after - before);
}

std::vector<char> carrying(const StaticSystem& system) {
  std::vector<char> carries;
  for (const RollerContact& contact : system.contacts()) carries.push_back(contact.normal > 0.0 ? 1 : 0);
  return carries;
}

/// Miss of the landing in steady laying, otherwise 0 [m].
double landing_miss_or_zero(const StaticSystem& system, const LineState& state) {
  return system.lays_steadily() ? system.landing_miss(state).value_or(0.0) : 0.0;
}

bool same_order(const Model& a, const Model& b) {
  return ranges::equal(a.spans, b.spans,
                       [](const SectionSpan& x, const SectionSpan& y) { return x.section == y.section; });
}

/// Distances from the tensioner and their shifts [m].
using Shifts = std::vector<std::pair<double, double>>;

/// Adds fixed points a few elements away from the moved limits. If nodes were spread over the whole line they would
/// slide over rollers, and mesh effects where the line bends sharply would be taken for effects of the model.
Shifts with_fixed_nodes(const Shifts& limits, const LineMesh& mesh) {
  constexpr double kElements = 6.0;
  const auto reach = [&](double u) {
    const double s = mesh.total_length() - u;
    const auto above = ranges::lower_bound(mesh.s, s);
    const std::ptrdiff_t e = above - mesh.s.begin(), last = mesh.elements() - 1;
    const double before = mesh.length[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(e - 1, 0, last))];
    const double after = mesh.length[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(e, 0, last))];
    return kElements * std::max(before, after);
  };
  Shifts all{limits.front()};
  for (std::size_t i = 1; i < limits.size(); ++i) {
    const double low = limits[i - 1].first + reach(limits[i - 1].first),
                 high = limits[i].first - reach(limits[i].first);
    if (low < high) {
      all.emplace_back(low, 0.0);
      all.emplace_back(high, 0.0);
    }
    all.push_back(limits[i]);
  }
  return all;
}

}  // namespace

std::optional<LineMesh> moved_mesh(const LineMesh& mesh, const Model& from, const Model& model) {
  if (!same_order(from, model)) return std::nullopt;
  const double total = mesh.total_length();
  Shifts limits{{0.0, 0.0}};
  const auto add_limit = [&](double from_top, double to) {
    if (from_top > limits.back().first && from_top < total) limits.emplace_back(from_top, to - from_top);
  };
  for (std::size_t i = 0; i < from.spans.size(); ++i) {
    add_limit(from.spans[i].from, model.spans[i].from);
    add_limit(from.spans[i].to, model.spans[i].to);
  }
  const double longer = model.description.pipe.length.value_or(0.0) - from.description.pipe.length.value_or(0.0);
  limits.emplace_back(total, longer);
  if (ranges::all_of(limits, [](const auto& limit) { return limit.second == 0.0; })) return mesh;
  limits = with_fixed_nodes(limits, mesh);
  const auto shift = [&](double u) {
    const auto after = ranges::find_if(limits, [&](const auto& limit) { return limit.first >= u; });
    if (after == limits.begin()) return after->second;
    if (after == limits.end()) return limits.back().second;
    const auto before = std::prev(after);
    const double share = (u - before->first) / (after->first - before->first);
    return before->second + share * (after->second - before->second);
  };
  LineMesh carried = mesh;
  for (std::size_t i = 0; i < mesh.length.size(); ++i) {
    const double low = shift(total - mesh.s[i]), high = shift(total - mesh.s[i + 1]);
    carried.length[i] += low - high;
    carried.s[i + 1] = mesh.s[i + 1] + longer - high;
  }
  return carried;
}

EquilibriumTangent::EquilibriumTangent(const Model& model, const StaticSolution& solution)
    : model_(&model),
      solution_(&solution),
      system_(model, model.mean_pose, solution.mesh),
      target_(find_target(model.description)) {
  system_.evaluate(solution.state, true);
  loaded_ = carrying(system_);
  system_.hold(true);
  regular_ = system_.factor(solution.state, target_);
}

EquilibriumTangent::Trial EquilibriumTangent::trial(const Model& model, LineMesh mesh) const {
  StaticSystem changed(model, model.mean_pose, mesh);
  Trial trial{std::move(mesh), displacement_to_ends(system_, changed, solution_->state), {}};
  LineState state = solution_->state;
  advance(state, solution_->state, trial.moved, 1.0);
  changed.evaluate(state, false);
  const double miss = landing_miss_or_zero(changed, state);
  trial.contacts_stay = carrying(changed) == loaded_;
  changed.hold(false);
  trial.out = {changed.residual(), changed.target_error(state, find_target(model.description)), miss};
  return trial;
}

StaticSolution EquilibriumTangent::solution_at(const Model& model, Trial trial, const Change& change,
                                               double sign) const {
  StaticSolution found;
  found.mesh = std::move(trial.mesh);
  add(trial.moved, sign, change.q);
  found.state = solution_->state;
  advance(found.state, solution_->state, trial.moved, 1.0);
  found.state.far_force += sign * change.far_force;
  found.pose = model.mean_pose;
  return found;
}

std::optional<StaticPair> EquilibriumTangent::neighbouring_equilibria(const Model& before, const Model& after) {
  const bool alike = before.supports.rollers.size() == model_->supports.rollers.size() &&
                     after.supports.rollers.size() == model_->supports.rollers.size();
  std::optional<LineMesh> mesh_before = moved_mesh(solution_->mesh, *model_, before);
  std::optional<LineMesh> mesh_after = moved_mesh(solution_->mesh, *model_, after);
  if (!regular_ || !alike || !mesh_before || !mesh_after) return std::nullopt;
  Trial low = trial(before, std::move(*mesh_before)), high = trial(after, std::move(*mesh_after));
  Imbalance out = high.out;
  std::transform(low.out.residual.begin(), low.out.residual.end(), high.out.residual.begin(), out.residual.begin(),
                 half);
  out.target = half(low.out.target, high.out.target);
  out.miss = half(low.out.miss, high.out.miss);
  const bool stay = low.contacts_stay && high.contacts_stay;
  const Change change = solve_imbalance(out);
  return StaticPair{solution_at(before, std::move(low), change, -1.0), solution_at(after, std::move(high), change, 1.0),
                    stay};
}

std::optional<StaticPair> EquilibriumTangent::push(int roller, double force) {
  const RollerContact& contact = system_.contacts()[static_cast<std::size_t>(roller)];
  if (!regular_ || !contact.closest.found) return std::nullopt;
  const std::size_t first = 6 * static_cast<std::size_t>(contact.closest.element);
  const double length = solution_->mesh.length[static_cast<std::size_t>(contact.closest.element)];
  const RollerDistance distance = roller_distance(system_.rollers().placed(roller), contact.closest);
  const HermiteValues shape = hermite(contact.closest.xi, length);
  Imbalance out{std::vector<double>(solution_->state.q.size(), 0.0), 0.0};
  for (std::size_t k = 0; k < 4; ++k) {
    Eigen::Map<Vec3>(out.residual.data() + first + 3 * k) = -force * shape.value[k] * distance.direction;
  }
  const Change change = solve_imbalance(out);
  Trial unchanged{solution_->mesh, std::vector<double>(solution_->state.q.size(), 0.0), {}};
  return StaticPair{solution_at(*model_, unchanged, change, -1.0), solution_at(*model_, unchanged, change, 1.0)};
}

void EquilibriumTangent::apply_inverse(const Imbalance& out, Change& change) {
  change.q = out.residual;
  change.far_force = out.target;
  for (double& value : change.q) value = -value;
  change.far_force = -change.far_force;
  system_.solve(change.q, change.far_force, -out.miss);
}

/// Effect of a change on the imbalance, by central differences: with plastic memory the tangent is incomplete.
EquilibriumTangent::Imbalance EquilibriumTangent::along(const Change& change) {
  double max_value = 0.0;
  for (const double value : change.q) max_value = std::max(max_value, std::abs(value));
  const double step = max_value > 0.0 ? kDifferenceStep / max_value : 1.0;
  LineState state = solution_->state;
  const auto look = [&](double share) {
    advance(state, solution_->state, change.q, share);
    state.far_force = solution_->state.far_force + share * change.far_force;
    system_.evaluate(state, false);
    const double miss = landing_miss_or_zero(system_, state);
    system_.hold(false);
    return Imbalance{system_.residual(), system_.target_error(state, target_), miss};
  };
  const Imbalance low = look(-step);
  Imbalance high = look(step);
  for (std::size_t i = 0; i < high.residual.size(); ++i) {
    high.residual[i] = half(low.residual[i], high.residual[i]) / step;
  }
  high.target = half(low.target, high.target) / step;
  high.miss = half(low.miss, high.miss) / step;
  return high;
}

/// Generalised conjugate residuals (Eisenstat, Elman and Schultz 1983), preconditioned with Newton's tangent;
/// directions found for one input are reused for the next (as in Parks et al. 2006).
EquilibriumTangent::Change EquilibriumTangent::solve_imbalance(const Imbalance& out) {
  Change change;
  if (!system_.has_plastic_memory()) {
    apply_inverse(out, change);
    return change;
  }
  const auto size = [](const Imbalance& of) {
    return std::sqrt(dot(of.residual, of.residual) + of.target * of.target + of.miss * of.miss);
  };
  const auto product = [](const Imbalance& a, const Imbalance& b) {
    return dot(a.residual, b.residual) + a.target * b.target + a.miss * b.miss;
  };
  Imbalance left = out;
  change.q.assign(out.residual.size(), 0.0);
  const auto take = [&](const std::pair<Change, Imbalance>& direction) {
    const double share = -product(left, direction.second);
    add(change.q, share, direction.first.q);
    change.far_force += share * direction.first.far_force;
    add(left.residual, share, direction.second.residual);
    left.target += share * direction.second.target;
    left.miss += share * direction.second.miss;
  };
  for (const auto& direction : directions_) take(direction);
  std::vector<std::pair<Change, Imbalance>> fresh;
  const auto part_from = [&](const std::vector<std::pair<Change, Imbalance>>& all, std::pair<Change, Imbalance>& next) {
    for (const auto& direction : all) {
      const double share = -product(next.second, direction.second);
      add(next.first.q, share, direction.first.q);
      next.first.far_force += share * direction.first.far_force;
      add(next.second.residual, share, direction.second.residual);
      next.second.target += share * direction.second.target;
      next.second.miss += share * direction.second.miss;
    }
  };
  for (int look = 0; look < kMaxDirections && size(left) > kTolerance * size(out); ++look) {
    std::pair<Change, Imbalance> next;
    apply_inverse(left, next.first);
    next.second = along(next.first);
    for (int pass = 0; pass < 2; ++pass) {  // the second pass removes rounding errors of the first
      part_from(directions_, next);
      part_from(fresh, next);
    }
    const double length = size(next.second);
    if (!(length > 0.0)) break;
    for (double& value : next.first.q) value /= length;
    next.first.far_force /= length;
    for (double& value : next.second.residual) value /= length;
    next.second.target /= length;
    next.second.miss /= length;
    const double before = size(left);
    take(next);
    fresh.push_back(std::move(next));
    if (look > 5 && size(left) > 0.9 * before) break;  // limit of the finite differences
  }
  for (auto& direction : fresh) {
    if (directions_.size() < kMaxKeptDirections) directions_.push_back(std::move(direction));
  }
  return change;
}

}  // namespace overbend
