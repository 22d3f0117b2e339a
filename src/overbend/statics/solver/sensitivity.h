/// How an equilibrium moves when the model changes a little, to first order: docs/theory/sensitivities.md.
///
/// With R(q, H; p) = 0 the held equations of statics and e(q, H; p) = 0 what is wanted of the line,
///     K dq/dp - d dH/dp = -dR/dp,    de/dq . dq/dp = -de/dp.
/// K is the exact tangent that Newton's method converged with, factored once; the right-hand sides are central
/// differences of R and e where the unknowns stand still and mesh and model are those of p - h and p + h.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "statics/equations/static_system.h"
#include "statics/solver/statics.h"

namespace overbend {

/// Equilibria to first order on either side of one that was solved.
struct StaticPair {
  StaticSolution before, after;
  /// Whether the same rollers carried wherever forces were differenced: else the step was too long.
  bool contacts_stay = true;
};

class EquilibriumTangent {
 public:
  /// At an equilibrium; `model` and `solution` must outlive this.
  EquilibriumTangent(const Model& model, const StaticSolution& solution);

  /// False where the tangent has no inverse: the pipe is about to snap to another place.
  bool regular() const { return regular_; }
  /// The system that the equilibrium is one of.
  const StaticSystem& system() const { return system_; }

  /// The equilibria of two models that lie a small step before and after this one, by the same step. Their number of
  /// spans and rollers is the same as here, else nothing comes back. Ends that are held go with the models, and so do
  /// the nodes at the limits of sections.
  std::optional<StaticPair> follow(const Model& before, const Model& after);
  /// Under minus and plus a small force [N] on the pipe at a roller, in the direction in which that would push it.
  std::optional<StaticPair> push(int roller, double force);

 private:
  struct Change {
    std::vector<double> q;
    double far_force = 0.0;
  };
  struct Imbalance {
    std::vector<double> residual;
    double target = 0.0;
    double miss = 0.0;  ///< Of the landing, in steady laying [m].
  };
  /// Where the unknowns are put, and what is out of balance there.
  struct Trial {
    LineMesh mesh;
    std::vector<double> moved;  ///< Of the held ends and those nodes that go with them.
    Imbalance out;
    bool contacts_stay = true;
  };
  Trial trial(const Model& model, LineMesh mesh) const;
  StaticSolution solution_at(const Model& model, Trial trial, const Change& change, double sign) const;
  Imbalance along(const Change& change);
  void apply_inverse(const Imbalance& out, Change& change);
  /// The change that takes an imbalance away.
  Change answer(const Imbalance& out);

  const Model* model_;
  const StaticSolution* solution_;
  StaticSystem system_;
  EquilibriumTarget target_;
  bool regular_ = false;
  std::vector<char> carries_;  ///< By roller.
  /// Of steel that remembers: changes looked at so far, and what they do; orthonormal in what they do.
  std::vector<std::pair<Change, Imbalance>> known_;
};

/// The mesh of `model` where the nodes at the limits of its sections go with these and those between are spread;
/// nothing where the sections follow each other otherwise than in `from`, of which `mesh` is one.
std::optional<LineMesh> carried_mesh(const LineMesh& mesh, const Model& from, const Model& model);

}  // namespace overbend
