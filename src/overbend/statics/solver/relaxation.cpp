#include "statics/solver/relaxation.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

constexpr int kMassRenewal = 200;  ///< Steps between evaluations of the tangent.

/// Masses for a unit step: dt^2 k_max / m < 4 for every row sum, with a factor of two for stiffening between renewals.
void renew_masses(StaticSystem& system, const LineState& state, std::vector<double>& mass) {
  system.evaluate(state, true);
  system.hold(true);
  BlockTridiagonal& k = system.tangent();
  for (int node = 0; node < k.nodes(); ++node) {
    for (int i = 0; i < kNodeDofs; ++i) {
      double sum = 0.0;
      for (int j = 0; j < kNodeDofs; ++j) {
        sum += std::abs(k.diag(node)[i * kRowWidth + j]);
        sum += node + 1 < k.nodes() ? std::abs(k.upper(node)[i * kRowWidth + j]) : 0.0;
        sum += node > 0 ? std::abs(k.lower(node - 1)[i * kRowWidth + j]) : 0.0;
      }
      mass[static_cast<std::size_t>(6 * node + i)] = 0.5 * sum;
    }
  }
}

/// True if the length of an element or a node's tangent has changed by more than half; steel pipes bear a hundredth of
/// that.
bool is_torn(const StaticSystem& system, const LineState& state) {
  const auto far_from = [](double value, double wanted) { return !(std::abs(value - wanted) <= 0.5 * wanted); };
  const auto vector = [&](std::size_t first) { return Eigen::Map<const Vec3>(state.q.data() + first); };
  for (std::size_t e = 0; e < system.mesh().length.size(); ++e) {
    const double chord = (vector(6 * e + 6) - vector(6 * e)).norm();
    if (far_from(chord, system.mesh().length[e]) || far_from(vector(6 * e + 9).norm(), 1.0)) {
      return true;
    }
  }
  return false;
}

}  // namespace

RelaxationReport relax(StaticSystem& system, LineState& state, const RelaxationSettings& settings) {
  RelaxationReport report;
  const std::size_t n = state.q.size();
  std::vector<double> velocity(n, 0.0), mass(n, 1.0);
  double energy_before = 0.0;
  while (report.steps < settings.max_steps) {
    if (report.steps % kMassRenewal == 0) {
      if (report.steps > 0 && is_torn(system, state)) {
        report.diverged = true;
        return report;
      }
      renew_masses(system, state, mass);
    } else {
      system.evaluate(state, false);
      system.hold(false);
    }
    report.residual = system.relative_residual();
    if (!std::isfinite(report.residual) || report.residual < settings.tolerance) {
      return report;
    }
    const std::vector<double>& r = system.residual();
    double energy = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      velocity[i] -= r[i] / mass[i];
      energy += 0.5 * mass[i] * velocity[i] * velocity[i];
    }
    if (energy < energy_before) {  // past the peak: restart with zero velocity
      std::fill(velocity.begin(), velocity.end(), 0.0);
      energy_before = 0.0;
    } else {
      for (std::size_t i = 0; i < n; ++i) {
        state.q[i] += velocity[i];
      }
      energy_before = energy;
    }
    ++report.steps;
  }
  return report;
}

}  // namespace overbend
