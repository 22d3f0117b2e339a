#include "support/explicit_step.h"

#include <cmath>

namespace overbend {
namespace {

constexpr double kMassDominates = 1e16;  ///< Share of acceleration at which stiffness is rounding [1/s2].

void predict(const DynamicState& now, double h, DynamicState& next) {
  next = now;  // same sizes: nothing is allocated
  next.time = now.time + h;
  next.last_step = h;
  for (std::size_t i = 0; i < now.q.size(); ++i) {
    next.q[i] = now.q[i] + h * (now.v[i] + 0.5 * h * now.acc[i]);
    next.v[i] = now.v[i] + h * now.acc[i];
  }
  for (GuideValues* guide : {&next.anchor_guide, &next.top_guide, &next.travel}) {
    guide->q += h * (guide->v + 0.5 * h * guide->acc);
    guide->v += h * guide->acc;
  }
}

/// Adds to the accelerations what the balance lacks: inertia is linear in them.
bool balance(DynamicSystem& system, const DynamicState& now, double h, DynamicState& next, std::vector<double>& dq) {
  system.evaluate(next, now, {0.0, kMassDominates, h}, true);
  system.hold(true);
  if (!system.solve_factored(dq)) {
    return false;
  }
  for (std::size_t i = 0; i < dq.size(); ++i) {
    next.acc[i] += kMassDominates * dq[i];
  }
  const auto along = [&](const Vec3& direction, std::size_t first) {
    return kMassDominates * (direction.x() * dq[first] + direction.y() * dq[first + 1] + direction.z() * dq[first + 2]);
  };
  next.anchor_guide.acc += along(system.surroundings().anchor.direction, 3);
  next.top_guide.acc += along(system.surroundings().top.direction, dq.size() - 3);
  if (system.line().tensioner.mode == TensionerMode::constant) {
    next.travel.acc -= along(system.surroundings().top.direction, dq.size() - 6);
  }
  return true;
}

}  // namespace

bool explicit_step(DynamicSystem& system, const DynamicState& now, double h, DynamicState& next) {
  std::vector<double> dq(now.q.size());
  predict(now, h, next);
  system.set_time(next.time, next);
  system.set_drive(first_drive(system.line().tensioner, now.machine));
  system.impose_ends(next);
  if (!balance(system, now, h, next, dq)) {
    return false;
  }
  bool finite = true;
  for (std::size_t i = 0; i < dq.size(); ++i) {
    next.v[i] = now.v[i] + 0.5 * h * (now.acc[i] + next.acc[i]);
    finite = finite && std::isfinite(next.v[i]);
  }
  next.anchor_guide.v = now.anchor_guide.v + 0.5 * h * (now.anchor_guide.acc + next.anchor_guide.acc);
  next.top_guide.v = now.top_guide.v + 0.5 * h * (now.top_guide.acc + next.top_guide.acc);
  next.travel.v = now.travel.v + 0.5 * h * (now.travel.acc + next.travel.acc);
  next.alg = next.acc;
  next.anchor_guide.alg = next.anchor_guide.acc;
  next.top_guide.alg = next.top_guide.acc;
  next.travel.alg = next.travel.acc;
  system.impose_ends(next);
  system.evaluate(next, now, {0.0, 0.0, h}, false);  // energies and forces at the ends belong to the state now
  return finite;
}

}  // namespace overbend
