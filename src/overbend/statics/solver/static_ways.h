/// Ways from a first guess to the equilibrium of one case on one mesh.
#pragma once

#include <string>

#include "results/static_results.h"
#include "statics/equations/static_system.h"
#include "statics/initial_shape/lay_shape.h"

namespace overbend {

/// One case on one mesh, on its way to equilibrium.
struct StaticCase {
  const Model& model;
  StaticSystem system;
  LineState state;
  EquilibriumTarget target;
  SolveReport report;
  double work = 0.0;         ///< Done so far: Newton steps times `size()`, and what else is looked at in their measure.
  double least_found = 0.0;  ///< Where a try ended without tension at the seabed: tension at the top then, else 0 [N].

  /// Words on the first box, seen from the tensioner, that the pipe lay beside where a way ended; empty where it lay on
  /// all.
  std::string left = {};
  /// Where the pipe of linear steel is bent most, when an equilibrium exists only for linear steel; else empty.
  std::string yielded = {};

  /// What one Newton step costs, in elements: the rollers count, each of which looks along the whole line.
  double size() const;
  /// What a case may cost before it is given up. Counted, not timed: every machine gives the same answer.
  double most_work() const;
  /// No way begins another stage then.
  bool spent() const { return work >= most_work(); }
};

/// Tries one way after another from the guess, with linear steel; the report names the one that worked.
bool solve_elastic(StaticCase& at, const LayShape& shape);

/// The steel is linear, until let_yield().
void make_elastic(StaticCase& at);

/// From the elastic shape to that of steel that yields: at once, or the plastic moments in steps.
bool let_yield(StaticCase& at);

/// From a solution close by: all at once.
bool follow(StaticCase& at, const char* stage);

/// From a shape close by: rollers and bed are softened and hardened again in steps, as long as they need be.
bool follow_softly(StaticCase& at);

}  // namespace overbend
