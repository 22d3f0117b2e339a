#include "hull/hull_run.h"

#include <Eigen/LU>
#include <utility>

namespace overbend {
namespace {

constexpr int kMaxIterations = 12;
constexpr double kTolerance = 1e-10;  // of the correction, relative to the motion of the step

/// Residual and tangent with the springs.
void balance(const Hull& hull, const HullSprings& springs, const HullState& state, const HullState& before, double step,
             const HullWeights& weights, double time, HullBalance& out) {
  balance_hull(hull, state, before, step, weights, time, out);
  out.residual += springs.stiffness * (state.h - springs.rest) + springs.damping * state.v;
  out.tangent += weights.stiffness * springs.stiffness + weights.damping * springs.damping;
}

/// Sets the state that follows from a true acceleration.
void set_acceleration(const GeneralizedAlpha& g, const HullState& before, double step, const Vec6& acc,
                      HullState& state) {
  for (int i = 0; i < 6; ++i) {
    const MotionValues m =
        advance(g, {before.h(i), before.v(i), before.acc(i), before.algorithmic_acceleration(i)}, step, acc(i));
    state.h(i) = m.q;
    state.v(i) = m.v;
    state.acc(i) = m.acc;
    state.algorithmic_acceleration(i) = m.algorithmic_acceleration;
  }
}

}  // namespace

void find_hull_acceleration(const Hull& hull, const HullSprings& springs, double time, HullState& state) {
  state.acc.setZero();
  HullBalance out;
  balance(hull, springs, state, state, 0.0, {0.0, 0.0, 1.0}, time, out);
  state.acc = -out.tangent.partialPivLu().solve(out.residual);
  state.algorithmic_acceleration = state.acc;
}

HullStepResult hull_step(const Hull& hull, const HullSprings& springs, const GeneralizedAlpha& scheme, double time,
                         double step, HullState& state, HullState& scratch) {
  const HullWeights weights{1.0, scheme.velocity_share(step), scheme.acceleration_share(step)};
  HullBalance out;
  Vec6 acc = state.acc;
  set_acceleration(scheme, state, step, acc, scratch);
  HullStepResult result;
  while (result.iterations < kMaxIterations) {
    ++result.iterations;
    balance(hull, springs, scratch, state, step, weights, time, out);
    const Vec6 change = -out.tangent.partialPivLu().solve(out.residual);
    if (!change.allFinite()) return result;
    acc += weights.mass * change;
    set_acceleration(scheme, state, step, acc, scratch);
    const double size = (step * state.v).norm() + (step * step * acc).norm() + 1e-9;
    if (change.norm() <= kTolerance * size) {
      result.converged = true;
      break;
    }
  }
  if (!result.converged) return result;
  finish_step(hull, state, step, scratch);
  std::swap(state, scratch);
  return result;
}

}  // namespace overbend
