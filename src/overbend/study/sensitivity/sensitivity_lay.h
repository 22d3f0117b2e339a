/// The lay of sensitivities, with the still-water lay that its checks need.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "model/model.h"
#include "results/static_results.h"
#include "statics/solver/sensitivity.h"
#include "study/run/stinger_response.h"

namespace overbend {

/// Results on both sides of an input, at the same small step.
struct ResultPair {
  StaticResults before, after;
  std::optional<StaticResults> still_water_before, still_water_after;  ///< In still water, if needed.
  bool contacts_stay = true;                                           ///< As in StaticPair.
};

class SensitivityLay {
 public:
  /// Lay at an equilibrium; both arguments must outlive this.
  SensitivityLay(const Model& model, const StaticSolution& solution);

  bool regular() const {
    return pipe_.regular() && stinger_.regular() && (!still_water_ || still_water_->tangent.regular());
  }
  const EquilibriumTangent& tangent() const { return pipe_; }
  /// Results of the equilibrium, including checks.
  const StaticResults& results() const { return results_; }
  /// Results in still water; null if not needed.
  const StaticResults* still_water_results() const { return still_water_ ? &still_water_->results : nullptr; }

  /// Returns the first-order results of the lay with two other descriptions, on both sides of its own.
  std::optional<ResultPair> neighbouring_equilibria(const Description& before, const Description& after);
  /// Returns the results under minus and plus a force at a roller [N], of the lay or, if `in_still_water`, of the lay
  /// in still water.
  std::optional<ResultPair> push(int roller, double force, bool in_still_water);

 private:
  /// The lay in still water, if the checks separate the effect of the current.
  struct StillWaterLay {
    Model model;
    StaticSolution solution;
    EquilibriumTangent tangent;
    StaticResults results;
    StillWaterLay(Model made, StaticSolution found);
  };
  /// Returns the model of another description, with floating sections of the stinger turned by `turns` [rad].
  Model rebuilt(const Description& description, const std::vector<double>& turns = {}) const;
  /// Returns the lay under minus and plus a force at a roller, including the response of its stinger; `low` and `high`
  /// become the models with the turned stinger.
  std::optional<StaticPair> push_pipe(int roller, double force, Model& low, Model& high);
  static std::unique_ptr<StillWaterLay> make_still_water_lay(const Model& model, const StaticSolution& solution);

  const Model* model_;
  const StaticSolution* solution_;
  bool held_;  ///< The vessel keeps the pose of the equilibrium.
  EquilibriumTangent pipe_;
  StingerResponse stinger_;
  std::unique_ptr<StillWaterLay> still_water_;
  StaticResults results_;
};

}  // namespace overbend
