/// First-order change of an equilibrium with the model: docs/theory/sensitivities.md.
///
/// With R(q, H; p) = 0 the held equations of statics and e(q, H; p) = 0 the target of the line,
///     K dq/dp - d dH/dp = -dR/dp,    de/dq . dq/dp = -de/dp.
/// K is the exact tangent with which Newton's method converged, factored once. The right-hand sides are central
/// differences of R and e at constant unknowns, with the mesh and model of p - h and p + h.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "statics/equations/static_system.h"
#include "statics/solver/statics.h"

namespace overbend {

/// First-order equilibria on either side of a solved one.
struct StaticPair {
  StaticSolution before, after;
  /// True if the same rollers carried in all evaluations; otherwise the step was too long.
  bool contacts_stay = true;
};

class EquilibriumTangent {
 public:
  /// `model` and its equilibrium `solution` must outlive this object.
  EquilibriumTangent(const Model& model, const StaticSolution& solution);

  /// False if the tangent is singular: the pipe is about to snap through.
  bool regular() const { return regular_; }
  /// System of the equilibrium.
  const StaticSystem& system() const { return system_; }

  /// Returns the equilibria of two models that differ from this one by minus and plus the same small step; nullopt if
  /// their number of spans or rollers differs. Held ends, and nodes at the limits of sections, move with the models.
  std::optional<StaticPair> neighbouring_equilibria(const Model& before, const Model& after);
  /// Equilibria under minus and plus a small force [N] on the pipe at a roller, in the direction in which that roller
  /// pushes.
  std::optional<StaticPair> push(int roller, double force);

 private:
  struct Change {
    std::vector<double> q;
    double far_force = 0.0;
  };
  struct Imbalance {
    std::vector<double> residual;
    double target = 0.0;
    double miss = 0.0;  ///< Miss of the landing, in steady laying [m].
  };
  /// Displaced unknowns and the imbalance there.
  struct Trial {
    LineMesh mesh;
    std::vector<double> moved;  ///< Displacements of the held ends and of the nodes that follow them.
    Imbalance out;
    bool contacts_stay = true;
  };
  Trial trial(const Model& model, LineMesh mesh) const;
  StaticSolution solution_at(const Model& model, Trial trial, const Change& change, double sign) const;
  Imbalance along(const Change& change);
  void apply_inverse(const Imbalance& out, Change& change);
  /// Returns the change that removes an imbalance.
  Change solve_imbalance(const Imbalance& out);

  const Model* model_;
  const StaticSolution* solution_;
  StaticSystem system_;
  EquilibriumTarget target_;
  bool regular_ = false;
  std::vector<char> loaded_;  ///< Per roller.
  /// For steel with memory: changes evaluated so far and their effects, orthonormal in the effects.
  std::vector<std::pair<Change, Imbalance>> directions_;
};

/// Returns `mesh`, which belongs to `from`, with the nodes at section limits moved to those of `model` and the nodes
/// between interpolated; nullopt if the order of the sections differs.
std::optional<LineMesh> moved_mesh(const LineMesh& mesh, const Model& from, const Model& model);

}  // namespace overbend
