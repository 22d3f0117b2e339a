#include "statics/solver/linked_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/ranges.h"
#include "base/require.h"
#include "base/shown_unit.h"
#include "hull/body_kinematics.h"
#include "model/bodies.h"
#include "statics/solver/floating_hull.h"

namespace overbend {
namespace {

constexpr double kQuasiStatic = 1e9;  // without inertia and damping: friction depends on the path [s]

std::size_t to_size(int i) {
  return static_cast<std::size_t>(i);
}

std::size_t find_line_index(const std::vector<FreeLineDescription>& lines, const std::string& name) {
  return static_cast<std::size_t>(ranges::find(lines, name, &FreeLineDescription::name) - lines.begin());
}

double mixed(double from, double to, double share) {
  return from + share * (to - from);
}

VesselOffset mixed(const VesselOffset& from, const VesselOffset& to, double share) {
  return {mixed(from.x, to.x, share), mixed(from.y, to.y, share), mixed(from.heading, to.heading, share)};
}

/// Rigid point at the first end of a line; its x axis continues the line at that end, without roll.
FreeBody weld_point(const LineState& first, double force_scale) {
  const Vec3 place = Eigen::Map<const Vec3>(first.q.data());
  const Vec3 ahead = -Eigen::Map<const Vec3>(first.q.data() + 3).normalized();
  FreeBody body = free_point(place, force_scale);
  // roll has no stiffness: nothing twists a line or restrains its roll
  body.held = {false, false, false, true, false, false};
  body.rest.h(4) = -std::asin(std::clamp(ahead.z(), -1.0, 1.0));
  body.rest.h(5) = std::atan2(ahead.y(), ahead.x());
  return body;
}

Vec3 turned_upwards(double kink) {
  return {std::cos(kink), 0.0, std::sin(kink)};
}

/// Purpose of a move to a position and how far it came, such as "davit 1 reached a length of 7.42 m instead of 1.00 m".
struct MoveProgress {
  std::string lines;  ///< Lines that were hauled, paid out or welded.
  std::string reached;

  void add(const std::string& name, const std::string& text) {
    if (!name.empty() && lines.find("line \"" + name + "\"") == std::string::npos) {
      lines += (lines.empty() ? "" : ", ") + std::string("line \"") + name + "\"";
    }
    if (!text.empty()) reached += (reached.empty() ? "" : ", ") + text;
  }
};

MoveProgress describe_progress(const std::vector<FreeLineDescription>& lines, const LiftPosition& reached,
                               const LiftPosition& target) {
  MoveProgress progress;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (target.tensions[i]) {
      progress.add(lines[i].name, fmt::format("{} reached a length of {} before its tension of {}", lines[i].name,
                                              shown(reached.lengths[i], "m", 2), shown(*target.tensions[i], "N", 1)));
    } else if (std::abs(target.lengths[i] - reached.lengths[i]) > 1e-9) {
      progress.add(lines[i].name, fmt::format("{} reached a length of {} instead of {}", lines[i].name,
                                              shown(reached.lengths[i], "m", 2), shown(target.lengths[i], "m", 3)));
    }
  }
  const VesselOffset &from = reached.vessel, &to = target.vessel;
  if (from.x != to.x || from.y != to.y || from.heading != to.heading) {
    progress.add("",
                 fmt::format("the vessel reached {} ahead and {} to port instead of {} and {}", shown(from.x, "m", 2),
                             shown(from.y, "m", 2), shown(to.x, "m", 2), shown(to.y, "m", 2)));
  }
  if (reached.closed < 1.0 && !target.joins.empty()) {
    const JoinDescription& join = target.joins.back();
    progress.add(join.first, fmt::format("{:.0f} % of the gap to be welded was closed", 100.0 * reached.closed));
    progress.add(join.second, "");
  }
  return progress;
}

StaticFailure unreachable(const std::vector<FreeLineDescription>& lines, const LiftPosition& reached,
                          const LiftPosition& target) {
  const MoveProgress progress = describe_progress(lines, reached, target);
  return {"no equilibrium was found", progress.lines,
          "no equilibrium exists on the way to the target position" +
              (progress.reached.empty() ? "" : ": " + progress.reached) +
              "; give lengths, tensions or positions within reach"};
}

}  // namespace

VesselPose moved_pose(const VesselPose& pose, const VesselOffset& offset) {
  VesselPose moved = pose;
  moved.p_WV += pose.R_WV * Vec3(offset.x, offset.y, 0.0);
  moved.R_WV = turned_about_z(-offset.heading) * pose.R_WV;
  return moved;
}

std::vector<VesselPose> poses_at(const Model& model, const LiftPosition& position) {
  std::vector<VesselPose> poses = body_poses(model);
  poses.front() = moved_pose(poses.front(), position.vessel);
  for (std::size_t i = 0; i < position.bodies.size(); ++i) poses[i + 1] = moved_pose(poses[i + 1], position.bodies[i]);
  return poses;
}

LiftPosition nominal_position(const Description& description) {
  LiftPosition position;
  for (const FreeLineDescription& line : description.lines) {
    position.lengths.push_back(unstressed_length(line));
    position.tensions.emplace_back();
  }
  position.bodies.resize(description.bodies.size());
  return position;
}

LiftPosition stage_position(const Description& description, const LayStageDescription& stage, LiftPosition from) {
  for (const LineValue& length : stage.lengths) {
    from.lengths[find_line_index(description.lines, length.line)] = length.value;
  }
  for (const LineValue& tension : stage.tensions) {
    from.tensions[find_line_index(description.lines, tension.line)] = tension.value;
  }
  if (stage.vessel) from.vessel = *stage.vessel;
  for (const BodyOffset& body : stage.bodies) from.bodies[body_index(description, body.body) - 1] = body.offset;
  if (stage.join) from.joins.push_back(*stage.join);
  return from;
}

LinkedLines::LinkedLines(const Model& model) : model_(&model), setup_(linked_lines_setup(model)) {
  float_vessel(model, setup_);
  state_ = make_initial_state(setup_, 0.0);
  position_ = nominal_position(model.description);
  for (std::size_t i = 0; i < position_.lengths.size(); ++i) {
    position_.lengths[i] = setup_.wires[i] >= 0 ? setup_.system.wires[to_size(setup_.wires[i])].length
                                                : setup_.system.lines[to_size(setup_.lines[i])].mesh.total_length();
  }
  assembly_.emplace(setup_.system);
}

/// Fixes the points at their present positions; bed friction is as left by the path.
StaticLines LinkedLines::make_static_lines() const {
  StaticLines lines{setup_, state_, {}};
  for (LineState& line : lines.state.lines) {
    ranges::fill(line.v, 0.0);
    lines.rest.lies_in_bow.push_back(true);
  }
  std::size_t number = 0;
  for (const int body : free_bodies(lines.setup.system)) {
    HullState& rest = lines.setup.system.bodies[to_size(body)].free->rest;
    rest = state_.bodies[number];
    rest.v = rest.acc = Vec6::Zero();
    lines.state.bodies[number++] = rest;
  }
  return lines;
}

LinkedLines::LinkedLines(const LinkedLines& source)
    : model_(source.model_),
      setup_(source.setup_),
      state_(source.state_),
      position_(source.position_),
      welds_(source.welds_),
      residual_(source.residual_),
      iterations_(source.iterations_) {
  assembly_.emplace(setup_.system);
  evaluate();
}

/// Evaluates the forces of the state itself: the displacement since is zero.
void LinkedLines::evaluate() {
  const SystemState laid = state_;
  Equilibrium(*assembly_, {LayHistory::monotonic, &laid, kQuasiStatic}).evaluate(state_, true);
}

/// Makes a body of the two ends in their present positions, with a gap; put() closes it.
void LinkedLines::weld(const JoinDescription& join) {
  const std::vector<FreeLineDescription>& lines = model_->description.lines;
  System& system = setup_.system;
  const int first = setup_.lines[find_line_index(lines, join.first)],
            second = setup_.lines[find_line_index(lines, join.second)];
  const double force_scale = system.lines[to_size(first)].force_scale;
  const int body = static_cast<int>(system.bodies.size());
  system.bodies.emplace_back().free = weld_point(state_.lines[to_size(first)], force_scale);
  const HullState& rest = system.bodies.back().free->rest;
  const BodyPose pose = make_pose(rest.h);
  state_.bodies.push_back(rest);
  const auto clamp = [&](int line, const Vec3& place, const Vec3& direction) -> std::size_t {
    const std::size_t index = 2 * to_size(line);
    Attachment& held = system.attachments[index];
    held.body = body;
    held.hold_place = held.hold_direction = true;
    held.place = place;
    held.direction = direction;
    const double* tangent = state_.lines[to_size(line)].q.data() + 3;
    state_.attachments[index].guide = {Eigen::Map<const Vec3>(tangent).norm(), 0.0, 0.0, 0.0};
    return index;
  };
  clamp(first, Vec3::Zero(), -Vec3::UnitX());
  const std::vector<double>& q = state_.lines[to_size(second)].q;
  Weld weld;
  weld.place = pose.R.transpose() * (Vec3(Eigen::Map<const Vec3>(q.data())) - pose.place);
  weld.direction = pose.R.transpose() * Eigen::Map<const Vec3>(q.data() + 3).normalized();
  weld.kink = join.kink;
  weld.attachment = clamp(second, weld.place, weld.direction);
  welds_.push_back(weld);
  assembly_.emplace(system);
}

/// Reverses the last weld().
void LinkedLines::undo_weld() {
  const std::size_t second = welds_.back().attachment;
  for (Attachment& held : setup_.system.attachments) {
    if (held.body != static_cast<int>(setup_.system.bodies.size()) - 1) continue;
    held.body = kGround;
    held.hold_place = held.hold_direction = false;
  }
  require(setup_.system.attachments[second].body == kGround, "a weld holds two ends");
  setup_.system.bodies.pop_back();
  welds_.pop_back();
  assembly_.emplace(setup_.system);
}

void LinkedLines::apply_position(const LiftPosition& position) {
  if (position.joins.size() == welds_.size() && !welds_.empty()) {
    const Weld& weld = welds_.back();
    Attachment& second = setup_.system.attachments[weld.attachment];
    second.place = (1.0 - position.closed) * weld.place;
    second.direction = (weld.direction + position.closed * (turned_upwards(weld.kink) - weld.direction)).normalized();
  }
  for (std::size_t i = 0; i < position.lengths.size(); ++i) {
    if (setup_.wires[i] >= 0) {
      Wire& wire = setup_.system.wires[to_size(setup_.wires[i])];
      wire.length = position.lengths[i];
      wire.held_tension = position.tensions[i];
    } else if (Line& line = setup_.system.lines[to_size(setup_.lines[i])];
               line.mesh.total_length() != position.lengths[i]) {
      set_length(line, position.lengths[i]);
    }
  }
  setup_.system.surroundings = static_surroundings(poses_at(*model_, position), setup_.system.attachments);
}

bool LinkedLines::rest(const SystemState& laid) {
  Equilibrium equilibrium(*assembly_, {LayHistory::monotonic, &laid, kQuasiStatic});
  NewtonSettings newton;
  newton.max_iterations = 300;
  newton.body_step = {5.0, 0.3};
  for (std::size_t i = 0; i < state_.lines.size(); ++i) {
    newton.tolerance = std::max(newton.tolerance, rounding_residual(setup_.system.lines[i], state_.lines[i].q));
  }
  const NewtonReport report = solve_equilibrium(equilibrium, state_, newton);
  iterations_ += report.iterations;
  residual_ = report.residual;
  return report.converged();
}

LiftPosition LinkedLines::between(const LiftPosition& target, double share) const {
  LiftPosition position = target;
  for (std::size_t i = 0; i < target.lengths.size(); ++i) {
    position.lengths[i] = mixed(position_.lengths[i], target.lengths[i], share);
    if (!target.tensions[i]) continue;
    if (setup_.wires[i] < 0) {  // hauled to its tension afterwards
      position.tensions[i].reset();
      continue;
    }
    const double tension = assembly_->wires()[to_size(setup_.wires[i])].tension;
    position.tensions[i] = mixed(tension, *target.tensions[i], share);
  }
  position.vessel = mixed(position_.vessel, target.vessel, share);
  for (std::size_t i = 0; i < target.bodies.size(); ++i) {
    position.bodies[i] = mixed(position_.bodies[i], target.bodies[i], share);
  }
  position.closed = mixed(position_.closed, 1.0, share);
  return position;
}

/// Ends the tension control of winches: their wires keep the lengths reached.
void LinkedLines::end_tension_control() {
  for (std::size_t i = 0; i < position_.lengths.size(); ++i) {
    if (setup_.wires[i] < 0 || !position_.tensions[i]) continue;
    const Wire& wire = setup_.system.wires[to_size(setup_.wires[i])];
    const WirePull& pull = assembly_->wires()[to_size(setup_.wires[i])];
    position_.lengths[i] = pull.span / (1.0 + pull.tension / wire.axial_stiffness);
    position_.tensions[i].reset();
  }
  apply_position(position_);
}

/// Releases a free-floating vessel once everything is in its nominal position; from then on lines have to hold it.
std::optional<StaticFailure> LinkedLines::release_vessel_if_floating() {
  if (!setup_.hull) return std::nullopt;
  if (afloat_) return find_vessel_stiffness(*model_, setup_, state_).failure;
  HeldVessel held = release_vessel(*model_, setup_, state_);
  if (held.failure) return std::move(held.failure);
  afloat_ = true;
  assembly_.emplace(setup_.system);
  const SystemState laid = state_;
  if (rest(laid)) return std::nullopt;
  return StaticFailure{"no equilibrium was found", "", "no common equilibrium of lines and vessel was found"};
}

/// Tension at the upper end of a line with weight [N].
double LinkedLines::upper_tension(std::size_t line) const {
  const std::vector<double>& q = state_.lines[line].q;
  const LineEnd upper = q[2] >= q[q.size() - 4] ? LineEnd::first : LineEnd::last;
  return Eigen::Map<const Vec3>(assembly_->line(line).end_force(upper).data()).norm();
}

/// Finds the lengths at which lines with weight have the given tensions at their upper ends, by Newton's method with
/// finite differences.
bool LinkedLines::find_lengths_for_tensions(const LiftPosition& target) {
  constexpr int kMaxIterations = 30;
  constexpr double kClose = 1e-7, kDifference = 1e-4, kMaxStep = 0.05;  // relative to the tension, to the length
  std::vector<std::size_t> which;
  for (std::size_t i = 0; i < target.tensions.size(); ++i) {
    if (target.tensions[i] && setup_.lines[i] >= 0) which.push_back(i);
  }
  const auto n = static_cast<Eigen::Index>(which.size());
  const auto errors = [&] {
    Eigen::VectorXd error(n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const std::size_t i = which[static_cast<std::size_t>(k)];
      error(k) = upper_tension(to_size(setup_.lines[i])) / *target.tensions[i] - 1.0;
    }
    return error;
  };
  for (int round = 0; n > 0 && round < kMaxIterations; ++round) {
    const Eigen::VectorXd error = errors();
    if (error.cwiseAbs().maxCoeff() < kClose) return true;
    Eigen::MatrixXd slope(n, n);
    for (Eigen::Index k = 0; k < n; ++k) {
      const SystemState base_state = state_;
      const LiftPosition position = position_;
      LiftPosition shortened = position_;
      shortened.lengths[which[static_cast<std::size_t>(k)]] *= 1.0 - kDifference;
      if (travel(shortened)) return false;
      slope.col(k) = (errors() - error) / -kDifference;  // derivative with respect to the logarithm of the length
      position_ = position;
      state_ = base_state;
      apply_position(position_);
    }
    const Eigen::VectorXd step = slope.partialPivLu().solve(-error);
    const double share = std::min(1.0, kMaxStep / step.cwiseAbs().maxCoeff());
    LiftPosition next = position_;
    for (Eigen::Index k = 0; k < n; ++k) next.lengths[which[static_cast<std::size_t>(k)]] *= 1.0 + share * step(k);
    if (travel(next)) return false;
  }
  return n == 0;
}

/// Returns a failure if a line would carry several times its breaking load.
std::optional<StaticFailure> LinkedLines::find_overstretched_line() const {
  constexpr double kMaxOverload = 3.0;  // times the breaking load
  const std::vector<FreeLineDescription>& lines = model_->description.lines;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const double tension = setup_.wires[i] >= 0 ? assembly_->wires()[to_size(setup_.wires[i])].tension
                                                : upper_tension(to_size(setup_.lines[i]));
    for (const LineSegmentDescription& segment : lines[i].segments) {
      const std::optional<double>& load = segment.type.breaking_load;
      if (!load || tension <= kMaxOverload * *load) continue;
      return StaticFailure{"a line cannot reach", "line \"" + lines[i].name + "\"",
                           fmt::format("with a length of {} it would carry {}, {:.1f} times its breaking load; make it "
                                       "longer, or move its ends closer together",
                                       shown(position_.lengths[i], "m", 3), shown(tension, "N", 1), tension / *load)};
    }
  }
  return std::nullopt;
}

std::optional<StaticFailure> LinkedLines::move_to(const LiftPosition& target) {
  const LiftPosition from = position_;
  const SystemState at_first = state_;
  const bool welds = target.joins.size() > welds_.size();
  if (welds) {
    weld(target.joins.back());
    position_.joins = target.joins;
    position_.closed = 0.0;
  }
  std::optional<StaticFailure> failure = travel(target);
  if (!failure && !find_lengths_for_tensions(target)) {
    failure = unreachable(model_->description.lines, position_, target);
    failure->why = "no length of these lines gives the requested tensions";
  }
  if (!failure) failure = find_overstretched_line();
  if (!failure) {
    end_tension_control();
    failure = release_vessel_if_floating();
    if (!failure) return std::nullopt;
  }
  if (welds) undo_weld();
  position_ = from;
  state_ = at_first;
  apply_position(position_);
  evaluate();
  return failure;
}

/// Moves everything to the target in increments; fails if even the smallest increment has no equilibrium.
std::optional<StaticFailure> LinkedLines::travel(const LiftPosition& target) {
  constexpr double kMinStep = 1.0 / 1024.0;
  const double max_step = model_->seabed.friction_axial > 0.0 ? 0.25 : 1.0;
  double increment = max_step;
  for (double done = 0.0; done < 1.0;) {
    increment = std::min(increment, 1.0 - done);
    const LiftPosition before = position_, next = between(target, increment / (1.0 - done));
    const SystemState laid = state_;
    apply_position(next);
    if (rest(laid)) {
      position_ = next;
      done = increment >= 1.0 - done ? 1.0 : done + increment;
      increment = std::min(2.0 * increment, max_step);
      continue;
    }
    state_ = laid;
    apply_position(before);
    increment *= 0.5;
    if (increment < kMinStep) {
      return unreachable(model_->description.lines, position_, target);
    }
  }
  return std::nullopt;
}

}  // namespace overbend
