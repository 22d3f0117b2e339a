/// The lay that sensitivities are of, with what its checks need beside it.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "model/model.h"
#include "results/static_results.h"
#include "statics/solver/sensitivity.h"
#include "study/run/stinger_response.h"

namespace overbend {

/// Results on either side, by the same small step.
struct ResultPair {
  StaticResults before, after;
  std::optional<StaticResults> still_before, still_after;  ///< In still water, where that is looked at.
  bool contacts_stay = true;                               ///< As in StaticPair.
};

class SensitivityLay {
 public:
  /// At an equilibrium; both must outlive this.
  SensitivityLay(const Model& model, const StaticSolution& solution);

  bool regular() const { return pipe_.regular() && stinger_.regular() && (!still_ || still_->tangent.regular()); }
  const EquilibriumTangent& tangent() const { return pipe_; }
  /// Results of the equilibrium itself, checks included.
  const StaticResults& results() const { return results_; }
  /// Likewise in still water; null where that is not looked at.
  const StaticResults* still_results() const { return still_ ? &still_->results : nullptr; }

  /// To first order, of the lay with two other descriptions on either side of its own.
  std::optional<ResultPair> follow(const Description& before, const Description& after);
  /// The same under minus and plus a force at a roller [N], of the lay or (`in_still`) of that in still water.
  std::optional<ResultPair> push(int roller, double force, bool in_still);

 private:
  /// The lay in still water, where the checks tell the current's effect apart.
  struct Still {
    Model model;
    StaticSolution solution;
    EquilibriumTangent tangent;
    StaticResults results;
    Still(Model made, StaticSolution found);
  };
  /// Of another description, floating sections of the stinger turned on by `turns` [rad].
  Model rebuilt(const Description& description, const std::vector<double>& turns = {}) const;
  /// The lay itself under minus and plus a force at a roller, its stinger following; models as they are turned.
  std::optional<StaticPair> push_pipe(int roller, double force, Model& low, Model& high);
  static std::unique_ptr<Still> still_lay(const Model& model, const StaticSolution& solution);

  const Model* model_;
  const StaticSolution* solution_;
  bool held_;  ///< The vessel stays where it was found.
  EquilibriumTangent pipe_;
  StingerResponse stinger_;
  std::unique_ptr<Still> still_;
  StaticResults results_;
};

}  // namespace overbend
