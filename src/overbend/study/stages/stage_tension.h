/// Stages of a lay operation solved in sequence, and the search for their tensions.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/description/description.h"
#include "results/operation_results.h"
#include "statics/moored/moored_lay.h"

namespace overbend {

/// A stage with its tension.
struct PlannedStage {
  LayStageDescription stage;
  std::string governing;                        ///< Limit that determines its sought tension; empty if none was sought.
  std::optional<StageFailure> infeasible;       ///< Reason that no tension is feasible.
  std::shared_ptr<const StaticSolution> close;  ///< Solution at a neighbouring tension, if the tension was sought.
};

/// Solves stages of one operation; keeps the last solution as the start of the next.
class StageSolver {
 public:
  /// `description` must outlive this.
  explicit StageSolver(const Description& description);

  /// Returns the stages with their tensions. Sought tensions are the minima that keep every limit, raised if
  /// neighbouring stages need more, so that the tension varies smoothly and no stage has less than it needs.
  std::vector<PlannedStage> plan(const std::vector<LayStageDescription>& stages);

  /// Solves a planned stage from the last solution.
  StageResult solve(const PlannedStage& planned);

 private:
  /// A limit and its utilisation [-].
  struct LimitUse {
    std::string limit;
    double used = 0.0;
  };
  struct Trial {
    std::optional<StaticResults> lay;
    std::optional<StaticFailure> failure;
  };

  Trial solve_at(LayStageDescription stage, std::optional<double> tension);
  /// Returns the highest utilisation at a tension; above 1 without an equilibrium.
  LimitUse worst_use(const LayStageDescription& stage, double tension);
  /// Solves the stage at its given tension or bottom tension.
  Trial at_given_tension(LayStageDescription& stage);
  /// Finds the top tension that gives the requested bottom tension.
  Trial with_bottom_tension(LayStageDescription& stage);
  static PlannedStage infeasible(const LayStageDescription& stage, const LimitUse& nearest, double tension,
                                 double max_tension);
  PlannedStage with_min_tension(const LayStageDescription& stage, double near);
  void smooth_tensions(std::vector<PlannedStage>& stages);
  std::optional<double> min_feasible_tension(const LayStageDescription& stage);
  double min_stage_tension(const LayStageDescription& stage) const;
  double moved_length(const LayStageDescription& stage) const;
  LoadHistory find_history(const LayStageDescription& stage);
  void keep_history(const LayStageDescription& stage);
  double find_max_tension() const;

  const Description& description_;
  std::optional<StaticSolution> last_;
  std::optional<bool> yields_;                    ///< True if any steel may yield; empty until known.
  std::shared_ptr<const StaticSolution> before_;  ///< With yielding steel: the last stage, or the lay before the first
                                                  ///< stage.
  double moved_length_ = 0.0;                     ///< Length by which the line had moved there [m].
};

}  // namespace overbend
