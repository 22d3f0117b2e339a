/// Equilibria of one lay at other tensions and depths, each from scratch as `overbend static` finds it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/description/description.h"
#include "results/lay_table_results.h"
#include "study/run/warm_start.h"

namespace overbend {

/// An equilibrium, or the reason that there is none.
struct LayCase {
  double tension = 0.0;  ///< Tension at the tensioner [N].
  double depth = 0.0;    ///< [m]
  std::optional<LayTableValues> lay;
  std::string reason;  ///< Reason that there is none, or the exceeded check.
  Findings serious{};  ///< Serious findings of its statics: checks judge the stresses of the pipe, not its position.

  bool passed() const { return lay && lay->passed(); }
};

class LayCases {
 public:
  /// Starts with the model's own lay, whose tension is given or follows from its length and anchor.
  explicit LayCases(const Description& description);

  const Description& description() const { return description_; }
  double own_tension() const { return own_.tension; }
  double own_depth() const { return description_.environment.water_depth; }
  /// Lay of the unchanged model; without values if that has no equilibrium.
  const LayCase& given_lay() const { return own_; }
  const Assumptions& assumptions() const { return assumptions_; }
  /// Number of equilibria calculated so far.
  int solves() const { return solves_; }

  /// Solves the lay at a tension [N] and a depth [m].
  LayCase at(double tension, double depth);
  /// Returns the lay with touchdown `lay_back` astern of the stern shoe [m], to a millimetre.
  LayCase at_lay_back(double lay_back, double depth);
  /// Returns the lay at the minimum tension that passes every governing check, to 0.1 %, regardless of the model's own
  /// tension: between half the submerged weight of the pipe over the depth and the tension at which its steel yields.
  /// If none passes, the lay nearest to passing.
  LayCase at_min_tension(double depth);

 private:
  struct Known {
    double tension, depth, lay_back;
  };
  const Known* nearest_by_lay_back(double lay_back, double depth) const;
  std::pair<LayCase, LayCase> around_lay_back(double lay_back, double depth);
  Description described(double tension, double depth) const;
  LayCase solve(const Description& description, double tension, double depth);
  /// Solves a lay from the last one tried, and replaces `last` by the new one.
  LayCase solve_from_last(double tension, double depth, std::shared_ptr<const LayWarmStart>& last);
  static LayCase make_lay_case(double tension, double depth, const StaticResults& results);

  Description description_;
  LayCase own_;
  std::vector<Known> known_;
  Assumptions assumptions_;
  int solves_ = 0;
};

}  // namespace overbend
