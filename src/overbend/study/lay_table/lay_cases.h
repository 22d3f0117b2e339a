/// Equilibria of one lay under other tensions and depths, each by itself as `overbend static` finds it.
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
#include "study/run/lay_beside.h"

namespace overbend {

/// An equilibrium, or why there is none.
struct LayCase {
  double tension = 0.0;  ///< At the tensioner [N].
  double depth = 0.0;    ///< [m]
  std::optional<LayTableValues> lay;
  std::string reason;  ///< Why there is none, or which check is exceeded.
  Findings serious{};  ///< Serious findings of its statics: checks judge the pipe, not its place.

  bool passed() const { return lay && lay->passed(); }
};

class LayCases {
 public:
  /// Of the model's own lay. `held_tension` is its tension, or the one that follows from its length and anchor.
  explicit LayCases(const Description& description);

  const Description& description() const { return description_; }
  double own_tension() const { return own_.tension; }
  double own_depth() const { return description_.environment.water_depth; }
  /// Of the model as it is; without a lay where that has none.
  const LayCase& own() const { return own_; }
  const Assumptions& assumptions() const { return assumptions_; }
  /// Equilibria calculated so far.
  int solves() const { return solves_; }

  LayCase at(double tension, double depth);
  /// The tension at which touchdown lies `lay_back` astern of the stern shoe, to a millimetre.
  LayCase at_lay_back(double lay_back, double depth);
  /// The least tension with which every governing check is passed, to a thousandth, whatever the model's own: between
  /// half of what the pipe weighs in water over the depth and the tension at which its steel yields. Without one the
  /// lay nearest to passing.
  LayCase at_least_tension(double depth);

 private:
  struct Known {
    double tension, depth, lay_back;
  };
  const Known* nearest_by_lay_back(double lay_back, double depth) const;
  std::pair<LayCase, LayCase> around_lay_back(double lay_back, double depth);
  Description described(double tension, double depth) const;
  LayCase solve(const Description& description, double tension, double depth);
  /// From the lay tried last; what it leaves is for the next.
  LayCase beside(double tension, double depth, std::shared_ptr<const LayStart>& last);
  static LayCase told(double tension, double depth, const StaticResults& results);

  Description description_;
  LayCase own_;
  std::vector<Known> known_;
  Assumptions assumptions_;
  int solves_ = 0;
};

}  // namespace overbend
