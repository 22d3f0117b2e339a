#include "support/explicit_step.h"

#include <cmath>

namespace overbend {
namespace {

constexpr double kMassDominates = 1e16;  ///< Share of acceleration at which stiffness is rounding [1/s2].

void predict(const SystemState& state, double h, SystemState& next) {
  next = state;  // same sizes: nothing is allocated
  next.time = state.time + h;
  next.last_step = h;
  for (std::size_t line = 0; line < state.lines.size(); ++line) {
    const LineState& from = state.lines[line];
    LineState& to = next.lines[line];
    for (std::size_t i = 0; i < from.q.size(); ++i) {
      to.q[i] = from.q[i] + h * (from.v[i] + 0.5 * h * from.acc[i]);
      to.v[i] = from.v[i] + h * from.acc[i];
    }
  }
  for (AttachmentState& end : next.attachments) {
    for (MotionValues* values : {&end.guide, &end.travel}) {
      values->q += h * (values->v + 0.5 * h * values->acc);
      values->v += h * values->acc;
    }
  }
}

/// Adds to the accelerations what the balance lacks: inertia is linear in them.
bool balance(Assembly& assembly, const SystemState& state, double h, SystemState& next) {
  assembly.evaluate(next, state, {0.0, kMassDominates, h}, true);
  assembly.hold(true);
  Increments dq = assembly.increments();
  if (!assembly.solve_factored(dq)) {
    return false;
  }
  for (std::size_t line = 0; line < dq.size(); ++line) {
    for (std::size_t i = 0; i < dq[line].size(); ++i) {
      next.lines[line].acc[i] += kMassDominates * dq[line][i];
    }
  }
  const System& system = assembly.system();
  for (std::size_t i = 0; i < next.attachments.size(); ++i) {
    const Attachment& held = system.attachments[i];
    const std::size_t line = static_cast<std::size_t>(held.line);
    const double* node_dofs = dq[line].data() + 6 * held_node(held, assembly.line(line).line());
    const Vec3& direction = assembly.surroundings().ends[i].direction;
    next.attachments[i].guide.acc += kMassDominates * direction.dot(Vec3(Eigen::Map<const Vec3>(node_dofs + 3)));
    if (held.tensioner && held.tensioner->mode == TensionerMode::constant) {
      next.attachments[i].travel.acc -= kMassDominates * direction.dot(Vec3(Eigen::Map<const Vec3>(node_dofs)));
    }
  }
  return true;
}

void finish(const MotionValues& motion_values, double h, MotionValues& next) {
  next.v = motion_values.v + 0.5 * h * (motion_values.acc + next.acc);
  next.algorithmic_acceleration = next.acc;
}

}  // namespace

bool explicit_step(Assembly& assembly, const SystemState& state, double h, SystemState& next) {
  predict(state, h, next);
  assembly.set_time(next.time, next);
  for (std::size_t i = 0; i < assembly.tensioners().size(); ++i) {
    const std::size_t attachment = assembly.tensioners()[i].attachment;
    assembly.set_drive(
        i, first_drive(*assembly.system().attachments[attachment].tensioner, state.attachments[attachment].machine));
  }
  assembly.impose_ends(next);
  if (!balance(assembly, state, h, next)) {
    return false;
  }
  bool finite = true;
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    const LineState& from = state.lines[line];
    LineState& to = next.lines[line];
    for (std::size_t i = 0; i < to.v.size(); ++i) {
      to.v[i] = from.v[i] + 0.5 * h * (from.acc[i] + to.acc[i]);
      finite = finite && std::isfinite(to.v[i]);
    }
    to.algorithmic_acceleration = to.acc;
  }
  for (std::size_t i = 0; i < next.attachments.size(); ++i) {
    finish(state.attachments[i].guide, h, next.attachments[i].guide);
    finish(state.attachments[i].travel, h, next.attachments[i].travel);
  }
  assembly.impose_ends(next);
  assembly.evaluate(next, state, {0.0, 0.0, h}, false);  // energies and forces at the ends belong to the state now
  return finite;
}

}  // namespace overbend
