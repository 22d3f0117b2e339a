#include "statics/solver/sensitivity.h"

#include <algorithm>
#include <cmath>

#include "mechanics/rod_element.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/stage_shape.h"
#include "statics/solver/static_start.h"

namespace overbend {
namespace {

constexpr double kLookAhead = 1e-5;    ///< Largest move of a node where the tangent is differenced [m].
constexpr double kWell = 1e-7;         ///< Of an imbalance, left where the tangent is not exact.
constexpr int kMostLooks = 25;         ///< Along which an imbalance is looked at.
constexpr std::size_t kMostKept = 40;  ///< Of these, what is kept for other inputs.

Vec3 tangent_at(const std::vector<double>& q, int node) {
  return Vec3(Eigen::Map<const Vec3>(q.data() + 6 * node + 3));
}

/// How far a place or direction goes when the heading turns from one horizontal unit vector to another.
Vec3 turned(const Vec3& from, const Vec3& to, const Vec3& d) {
  const double sine = from.cross(to).z(), back = sine * sine / (1.0 + from.dot(to));
  return {-back * d.x() - sine * d.y(), sine * d.x() - back * d.y(), 0.0};
}

/// How far the unknowns of a state have to go for its ends to be held as `to` holds them. The line goes along as a
/// whole with the tensioner and its heading, in height each node by its share, so that nothing is stretched sharply;
/// where nodes go makes no difference to what is found.
std::vector<double> way_to_ends(const StaticSystem& from, const StaticSystem& to, const LineState& state) {
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
  std::vector<double> way(state.q.size(), 0.0);
  for (int node = 0; node < mesh.nodes(); ++node) {
    const double share = mesh.s[static_cast<std::size_t>(node)] / mesh.total_length();
    const Vec3 place = Eigen::Map<const Vec3>(state.q.data() + 6 * node);
    Eigen::Map<Vec3>(way.data() + 6 * node) =
        with_vessel(place) + share * top.z() * Vec3::UnitZ() + (1.0 - share) * far_way;
    Eigen::Map<Vec3>(way.data() + 6 * node + 3) = turn(tangent_at(state.q, node));
  }
  const int last = mesh.nodes() - 1;
  Eigen::Map<Vec3>(way.data() + 6 * last) = top;
  if (!pinned) {
    Eigen::Map<Vec3>(way.data() + 3) =
        tangent_at(state.q, 0).dot(from.far_direction()) * (to.far_direction() - from.far_direction());
  }
  if (from.held_direction() && to.held_direction()) {
    Eigen::Map<Vec3>(way.data() + 6 * last + 3) =
        tangent_at(state.q, last).dot(*from.held_direction()) * (*to.held_direction() - *from.held_direction());
  }
  return way;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

void add(std::vector<double>& a, double factor, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += factor * b[i];
}

/// Half of what lies between.
double half(double before, double after) {
  return 0.5 * (after - before);
}

std::vector<char> carrying(const StaticSystem& system) {
  std::vector<char> carries;
  for (const RollerContact& contact : system.contacts()) carries.push_back(contact.normal > 0.0 ? 1 : 0);
  return carries;
}

/// In steady laying.
double miss_of(const StaticSystem& system, const LineState& state) {
  return system.lays_steadily() ? system.landing_miss(state).value_or(0.0) : 0.0;
}

bool same_order(const Model& a, const Model& b) {
  return std::ranges::equal(a.spans, b.spans,
                            [](const SectionSpan& x, const SectionSpan& y) { return x.section == y.section; });
}

/// Distances from the tensioner, and how far each goes [m].
using Shifts = std::vector<std::pair<double, double>>;

/// Nodes farther than a few elements from what goes stand still: spread all the way they would slide over rollers, and
/// what the mesh does to a line that turns sharply there would be taken for what the model does.
Shifts with_standing_nodes(const Shifts& limits, const LineMesh& mesh) {
  constexpr double kElements = 6.0;
  const auto reach = [&](double u) {
    const double s = mesh.total_length() - u;
    const auto above = std::ranges::lower_bound(mesh.s, s);
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

std::optional<LineMesh> carried_mesh(const LineMesh& mesh, const Model& from, const Model& model) {
  if (!same_order(from, model)) return std::nullopt;
  const double total = mesh.total_length();
  Shifts limits{{0.0, 0.0}};
  const auto add_limit = [&](double at, double to) {
    if (at > limits.back().first && at < total) limits.emplace_back(at, to - at);
  };
  for (std::size_t i = 0; i < from.spans.size(); ++i) {
    add_limit(from.spans[i].from, model.spans[i].from);
    add_limit(from.spans[i].to, model.spans[i].to);
  }
  const double longer = model.description.pipe.length.value_or(0.0) - from.description.pipe.length.value_or(0.0);
  limits.emplace_back(total, longer);
  if (std::ranges::all_of(limits, [](const auto& limit) { return limit.second == 0.0; })) return mesh;
  limits = with_standing_nodes(limits, mesh);
  const auto shift = [&](double u) {
    const auto after = std::ranges::find_if(limits, [&](const auto& limit) { return limit.first >= u; });
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
      target_(wanted_of(model.description)) {
  system_.evaluate(solution.state, true);
  carries_ = carrying(system_);
  system_.hold(true);
  regular_ = system_.factor(solution.state, target_);
}

EquilibriumTangent::Trial EquilibriumTangent::trial(const Model& model, LineMesh mesh) const {
  StaticSystem there(model, model.mean_pose, mesh);
  Trial trial{std::move(mesh), way_to_ends(system_, there, solution_->state), {}};
  LineState state = solution_->state;
  advance(state, solution_->state, trial.moved, 1.0);
  there.evaluate(state, false);
  const double miss = miss_of(there, state);
  trial.contacts_stay = carrying(there) == carries_;
  there.hold(false);
  trial.out = {there.residual(), there.target_error(state, wanted_of(model.description)), miss};
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

std::optional<StaticPair> EquilibriumTangent::follow(const Model& before, const Model& after) {
  const bool alike = before.supports.rollers.size() == model_->supports.rollers.size() &&
                     after.supports.rollers.size() == model_->supports.rollers.size();
  std::optional<LineMesh> mesh_before = carried_mesh(solution_->mesh, *model_, before);
  std::optional<LineMesh> mesh_after = carried_mesh(solution_->mesh, *model_, after);
  if (!regular_ || !alike || !mesh_before || !mesh_after) return std::nullopt;
  Trial low = trial(before, std::move(*mesh_before)), high = trial(after, std::move(*mesh_after));
  Imbalance out = high.out;
  std::ranges::transform(low.out.residual, high.out.residual, out.residual.begin(), half);
  out.target = half(low.out.target, high.out.target);
  out.miss = half(low.out.miss, high.out.miss);
  const bool stay = low.contacts_stay && high.contacts_stay;
  const Change change = answer(out);
  return StaticPair{solution_at(before, std::move(low), change, -1.0), solution_at(after, std::move(high), change, 1.0),
                    stay};
}

std::optional<StaticPair> EquilibriumTangent::push(int roller, double force) {
  const RollerContact& contact = system_.contacts()[static_cast<std::size_t>(roller)];
  if (!regular_ || !contact.at.found) return std::nullopt;
  const std::size_t first = 6 * static_cast<std::size_t>(contact.at.element);
  const double length = solution_->mesh.length[static_cast<std::size_t>(contact.at.element)];
  const RollerDistance distance = roller_distance(system_.rollers().placed(roller), contact.at);
  const HermiteValues shape = hermite(contact.at.xi, length);
  Imbalance out{std::vector<double>(solution_->state.q.size(), 0.0), 0.0};
  for (std::size_t k = 0; k < 4; ++k) {
    Eigen::Map<Vec3>(out.residual.data() + first + 3 * k) = -force * shape.value[k] * distance.direction;
  }
  const Change change = answer(out);
  Trial still{solution_->mesh, std::vector<double>(solution_->state.q.size(), 0.0), {}};
  return StaticPair{solution_at(*model_, still, change, -1.0), solution_at(*model_, still, change, 1.0)};
}

void EquilibriumTangent::apply_inverse(const Imbalance& out, Change& change) {
  change.q = out.residual;
  change.far_force = out.target;
  for (double& value : change.q) value = -value;
  change.far_force = -change.far_force;
  system_.solve(change.q, change.far_force, -out.miss);
}

/// What a change does to the imbalance, by central differences: of steel that remembers the tangent does not know all.
EquilibriumTangent::Imbalance EquilibriumTangent::along(const Change& change) {
  double largest = 0.0;
  for (const double value : change.q) largest = std::max(largest, std::abs(value));
  const double step = largest > 0.0 ? kLookAhead / largest : 1.0;
  LineState state = solution_->state;
  const auto look = [&](double share) {
    advance(state, solution_->state, change.q, share);
    state.far_force = solution_->state.far_force + share * change.far_force;
    system_.evaluate(state, false);
    const double miss = miss_of(system_, state);
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

/// Generalised conjugate residuals (Eisenstat, Elman and Schultz 1983) with Newton's tangent in front; what was learnt
/// for one input serves the next (as in Parks et al. 2006).
EquilibriumTangent::Change EquilibriumTangent::answer(const Imbalance& out) {
  Change change;
  if (!system_.remembers()) {
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
  const auto take = [&](const std::pair<Change, Imbalance>& one) {
    const double share = -product(left, one.second);
    add(change.q, share, one.first.q);
    change.far_force += share * one.first.far_force;
    add(left.residual, share, one.second.residual);
    left.target += share * one.second.target;
    left.miss += share * one.second.miss;
  };
  for (const auto& one : known_) take(one);
  std::vector<std::pair<Change, Imbalance>> fresh;
  const auto part_from = [&](const std::vector<std::pair<Change, Imbalance>>& all, std::pair<Change, Imbalance>& next) {
    for (const auto& one : all) {
      const double share = -product(next.second, one.second);
      add(next.first.q, share, one.first.q);
      next.first.far_force += share * one.first.far_force;
      add(next.second.residual, share, one.second.residual);
      next.second.target += share * one.second.target;
      next.second.miss += share * one.second.miss;
    }
  };
  for (int look = 0; look < kMostLooks && size(left) > kWell * size(out); ++look) {
    std::pair<Change, Imbalance> next;
    apply_inverse(left, next.first);
    next.second = along(next.first);
    for (int pass = 0; pass < 2; ++pass) {  // the second takes away what rounding leaves
      part_from(known_, next);
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
    if (look > 5 && size(left) > 0.9 * before) break;  // differences say no more
  }
  for (auto& one : fresh) {
    if (known_.size() < kMostKept) known_.push_back(std::move(one));
  }
  return change;
}

}  // namespace overbend
