/// Recording of single lines: tension at their ends and along them, over all steps.
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
  /// Records the model's own lines. The model must outlive this.
  LineRecorder(const Model& model, const System& system, const std::vector<FollowedLine>& lines);

  /// Adds an accepted step. Allocates nothing.
  void add(const SystemState& state, const Assembly& assembly);
  /// Number of nodes of all lines, which are their points in a snapshot.
  int points() const;
  /// Writes x, y, z [m] and effective tension [N] of every node to `out`; returns the end.
  double* append_snapshot(const SystemState& state, const Assembly& assembly, double* out) const;

  std::vector<LineDynamics> results() const;

  std::vector<double> save() const;
  void restore(const std::vector<double>& saved);

 private:
  struct RecordedLine {
    FollowedLine line;
    std::vector<double> arc;  ///< Unstressed length to the nodes [m].
    double min_first = 1e300, max_first = -1e300, min_last = 1e300, max_last = -1e300;  ///< [N]
    std::vector<double> min_tension, max_tension;  ///< Minimum and maximum tension at the nodes [N].
    std::vector<double> moment;  ///< Maximum bending moment at the nodes [N m]; empty if the line does not bend.
    RunningStatistics ends{2};   ///< Tensions at the ends, each step weighted by its length.
  };
  std::optional<double> utilisation(const RecordedLine& line) const;

  const Model* model_;
  std::vector<RecordedLine> lines_;
};

/// Warns of lines beyond their breaking load and of lines that fall slack or are compressed. `rest`: the same lines in
/// statics.
Findings line_findings(const Model& model, const std::vector<LineResult>& rest, const std::vector<LineDynamics>& lines);

}  // namespace overbend
