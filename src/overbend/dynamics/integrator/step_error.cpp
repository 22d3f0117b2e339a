#include "dynamics/integrator/step_error.h"

#include <algorithm>
#include <cmath>

namespace overbend {
namespace {

/// Lumped mass for the error estimate: half of each element's mass at its nodes, and the share of the tangents from the
/// cubic shape functions.
std::vector<double> lumped_mass(const Line& line) {
  std::vector<double> mass(6 * static_cast<std::size_t>(line.mesh.nodes()), 0.0);
  for (std::size_t e = 0; e < line.mesh.length.size(); ++e) {
    const double h = line.mesh.length[e];
    const double m = (line.elements.mass[e] + line.elements.added_normal[e]) * h;
    for (std::size_t node = e; node < e + 2; ++node) {
      for (std::size_t i = 0; i < 3; ++i) {
        mass[6 * node + i] += 0.5 * m;
        mass[6 * node + 3 + i] += m * h * h / 105.0;
      }
    }
  }
  return mass;
}

/// Weights of the nodal errors. Pipe counts in full, except pipe that was added behind the far end of the static line.
/// For that and for moorings, an error affects the forces by turning the elements next to the node, which matters less
/// the longer they are; up to `short_element` it counts in full. (Lines that may touch rollers are pipe.)
std::vector<double> error_weights(const Line& line, double short_element) {
  std::vector<double> weights;
  for (int node = 0; node < line.mesh.nodes(); ++node) {
    const bool pipe = line.on_rollers && line.mesh.s[static_cast<std::size_t>(node)] >= 0.0;
    weights.push_back(pipe ? 1.0 : std::min(1.0, short_element / line.mesh.min_neighbour_length(node)));
  }
  return weights;
}

/// Squared error of the bodies among the filtered errors [m2].
double body_error(const Assembly& assembly, const Increments& dq) {
  double worst = 0.0;
  for (std::size_t i = 0; i < assembly.free_bodies(); ++i) {
    const Vec6 dh = Eigen::Map<const Vec6>(dq.back().data() + 6 * i);
    const double arm = assembly.free_body(i).arm;
    worst = std::max({worst, dh.head<3>().squaredNorm(), arm * arm * dh.tail<3>().squaredNorm()});
  }
  return worst;
}

}  // namespace

StepError::StepError(const System& system, const GeneralizedAlpha& scheme, double short_element) : scheme_(scheme) {
  for (const Line& line : system.lines) {
    lumped_mass_.push_back(lumped_mass(line));
    weights_.push_back(error_weights(line, short_element));
  }
}

double StepError::operator()(Assembly& assembly, const SystemState& start, const SystemState& next,
                             Increments& dq) const {
  const double h = next.last_step;
  const double factor = std::abs(1.0 / 6.0 - scheme_.beta) * h * h * scheme_.acceleration_share(h);
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    for (std::size_t i = 0; i < dq[line].size(); ++i) {
      dq[line][i] = factor * lumped_mass_[line][i] * (next.lines[line].acc[i] - start.lines[line].acc[i]);
    }
  }
  for (const Attachment& held : assembly.system().attachments) {
    const std::size_t line = static_cast<std::size_t>(held.line);
    const auto node = dq[line].begin() + 6 * held_node(held, assembly.line(line).line());
    std::fill_n(node, held.hold_place ? 6 : 0, 0.0);
  }
  for (std::size_t i = 0; i < next.bodies.size(); ++i) {
    const Vec6 change = next.bodies[i].acc - start.bodies[i].acc;
    Eigen::Map<Vec6>(dq.back().data() + 6 * i) = factor * assembly.free_body(i).inertia.cwiseProduct(change);
  }
  assembly.apply_factors(dq);
  double worst = body_error(assembly, dq);
  for (std::size_t line = 0; line < next.lines.size(); ++line) {
    const std::vector<double>& e = dq[line];
    for (std::size_t i = 0; i < e.size(); i += 6) {
      const double weight = weights_[line][i / 6];
      worst = std::max(worst, weight * weight * (e[i] * e[i] + e[i + 1] * e[i + 1] + e[i + 2] * e[i + 2]));
    }
  }
  return std::sqrt(worst);
}

}  // namespace overbend
