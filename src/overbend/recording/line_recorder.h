/// What is recorded of lines that stand by themselves: tension at their ends and along them, over all steps.
#pragma once

#include "model/model.h"
#include "numerics/running_statistics.h"
#include "results/dynamic_results.h"
#include "results/line_results.h"
#include "system/followed_line.h"

namespace overbend {

/// Counts from t = 0 on.
class LineRecorder {
 public:
  /// The model's own lines. The model must outlive it.
  LineRecorder(const Model& model, const System& system, const std::vector<FollowedLine>& lines);

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
    FollowedLine line;
    std::vector<double> arc;  ///< Unstressed length to the nodes [m].
    double least_first = 1e300, most_first = -1e300, least_last = 1e300, most_last = -1e300;  ///< [N]
    std::vector<double> least, most;  ///< Tension at the nodes [N].
    std::vector<double> moment;       ///< Largest bending moment there; empty where the line does not bend [N m].
    RunningStatistics ends{2};        ///< Of the tensions at the ends, every step by its length.
  };
  std::optional<double> utilisation(const Followed& line) const;

  const Model* model_;
  std::vector<Followed> lines_;
};

/// Lines beyond their breaking load, lines that fall slack or are pushed. `rest`: the same lines at rest.
Findings line_findings(const Model& model, const std::vector<LineResult>& rest, const std::vector<LineDynamics>& lines);

}  // namespace overbend
