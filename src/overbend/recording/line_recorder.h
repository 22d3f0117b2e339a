/// What is recorded of lines that stand by themselves: tension at their ends and along them, over all steps.
#pragma once

#include "model/model.h"
#include "numerics/running_statistics.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"
#include "system/assembly.h"

namespace overbend {

/// The part along a line of the force that holds an end, negative where it pushes: a line that is stiff bears some
/// compression. Not the force's size with a sign: at a clamped end that bears a weight across the line, it would leap
/// from one side of zero to the other with every small push [N].
double end_tension(const Assembly& assembly, const SystemState& state, std::size_t line, LineEnd end);

/// Counts from t = 0 on.
class LineRecorder {
 public:
  /// The model's own lines, `count` of them; they stand in the system from `first` on. The model must outlive it.
  LineRecorder(const Model& model, const System& system, std::size_t first, std::size_t count);

  /// An accepted step. Nothing is allocated.
  void add(const SystemState& state, const Assembly& assembly);
  /// Nodes of all lines: their points in a snapshot.
  int points() const;
  /// Puts x, y, z [m] and effective tension [N] of every node to `out`; returns where they end.
  double* film(const SystemState& state, const Assembly& assembly, double* out) const;

  std::vector<LineDynamics> results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct Followed {
    double least_first = 1e300, most_first = -1e300, least_last = 1e300, most_last = -1e300;  ///< [N]
    std::vector<double> least, most;  ///< Tension at the nodes [N].
    RunningStatistics ends{2};        ///< Of the tensions at the ends, every step by its length.
  };
  std::optional<double> utilisation(std::size_t line) const;

  const Model* model_;
  std::size_t first_;
  std::vector<const std::vector<double>*> arc_;  ///< Unstressed length to the nodes, line by line [m].
  std::vector<Followed> lines_;
};

/// Lines beyond their breaking load, lines that fall slack or are pushed. `rest`: the same lines at rest.
Findings line_findings(const Model& model, const std::vector<LineResult>& rest, const std::vector<LineDynamics>& lines);

}  // namespace overbend
