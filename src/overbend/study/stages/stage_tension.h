/// The stages of an operation solved one from the other, and the tensions that are sought for them.
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
  std::string governing;                 ///< The limit that its sought tension is on; empty where none was sought.
  std::optional<StageFailure> hopeless;  ///< Why no tension serves.
  std::shared_ptr<const StaticSolution> close;  ///< Of a tension tried close to it, where it was sought.
};

/// Solves stages of one operation; remembers the last solution, from which the next is found.
class StageSolver {
 public:
  /// `description` must outlive this.
  explicit StageSolver(const Description& description);

  /// The stages with their tensions. Sought ones are the least that keep every limit, raised where their neighbours
  /// need more, so that the tension goes evenly from stage to stage and no stage has less than it needs.
  std::vector<PlannedStage> plan(const std::vector<LayStageDescription>& stages);

  StageResult solve(const PlannedStage& planned);

 private:
  /// A limit, and how much of it is used [-].
  struct Use {
    std::string limit;
    double used = 0.0;
  };
  struct Tried {
    std::optional<StaticResults> lay;
    std::optional<StaticFailure> failure;
  };

  Tried solve_at(LayStageDescription stage, std::optional<double> tension);
  /// What is used most at a tension; above 1 without an equilibrium.
  Use worst_use(const LayStageDescription& stage, double tension);
  /// With the tension, or the bottom tension, that the stage says.
  Tried as_asked(LayStageDescription& stage);
  /// Gives the stage the tension at the top with which its bottom tension is as asked for.
  Tried with_bottom_tension(LayStageDescription& stage);
  static PlannedStage hopeless(const LayStageDescription& stage, const Use& nearest, double tension, double most);
  PlannedStage with_least_tension(const LayStageDescription& stage, double near);
  void even_out(std::vector<PlannedStage>& stages);
  std::optional<double> tension_that_stands(const LayStageDescription& stage);
  double least_weight(const LayStageDescription& stage) const;
  double gone(const LayStageDescription& stage) const;
  LinePast past_of(const LayStageDescription& stage);
  void keep_past(const LayStageDescription& stage);
  double most_tension() const;

  const Description& description_;
  std::optional<StaticSolution> last_;
  std::optional<bool> yields_;                    ///< Whether any steel does.
  std::shared_ptr<const StaticSolution> before_;  ///< Where steel yields: the last stage, or the lay before the first.
  double gone_ = 0.0;                             ///< How far the line had gone there [m].
};

}  // namespace overbend
