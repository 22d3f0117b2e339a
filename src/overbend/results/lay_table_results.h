/// A table of lays: one row per equilibrium. SI.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/description/lay_table_description.h"
#include "results/verdict.h"

namespace overbend {

/// What a row is.
enum class LayRowKind {
  step,     ///< One of the values asked for.
  least,    ///< The least value of what is varied with which every governing check is passed.
  largest,  ///< The largest.
};

/// An equilibrium in the numbers that a lay table has.
struct LayTableValues {
  double top_tension = 0.0;              ///< Effective, at the tensioner [N].
  double bottom_tension = 0.0;           ///< Horizontal, at touchdown [N].
  double lay_back = 0.0;                 ///< Stern shoe to touchdown [m].
  double departure_angle = 0.0;          ///< At the last support in contact, or the tensioner of a J-lay [rad].
  std::optional<double> tip_separation;  ///< At the last row of the stinger [m].
  double overbend_bending_stress = 0.0;  ///< Of the tower in a J-lay [Pa].
  double overbend_von_mises = 0.0;       ///< Likewise [Pa].
  double overbend_strain = 0.0;          ///< Likewise [-].
  double sagbend_bending_stress = 0.0;   ///< [Pa]
  double sagbend_von_mises = 0.0;        ///< [Pa]
  double sagbend_strain = 0.0;           ///< [-]
  double largest_reaction = 0.0;         ///< Of a single roller [N].
  std::string largest_reaction_support;  ///< Box of that roller.
  std::optional<double> utilisation;     ///< Of the governing check that is used most; none where none is judged.
  std::string worst_check;               ///< Its name.
  std::string tip;                       ///< Where it is of the stinger tip, from which box on.
  VerdictKind verdict = VerdictKind::not_judged;

  bool passed() const { return verdict == VerdictKind::passed; }
};

struct LayTableRow {
  LayRowKind kind = LayRowKind::step;
  double varied = 0.0;                ///< Tension [N], lay-back or depth [m], as asked for or found.
  std::optional<double> distance;     ///< Along the route [m].
  double depth = 0.0;                 ///< Of the water [m].
  std::optional<LayTableValues> lay;  ///< None where no lay stands.
  std::string reason;                 ///< Why not, or what is exceeded, or what ends the range; may be empty.
  Findings serious;                   ///< What no check judges: a pipe beside its stinger, formulas that do not hold.
  int solves = 0;                     ///< Equilibria that it took.
};

/// Reason and serious findings in one text.
inline std::string remark_of(const LayTableRow& row) {
  std::string remark = row.reason;
  if (row.lay && !row.lay->tip.empty()) remark += (remark.empty() ? "" : "; ") + row.lay->tip;
  for (const Finding& finding : row.serious) remark += (remark.empty() ? "" : "; ") + finding.message;
  return remark;
}

struct LayTable {
  std::string title, version;
  LayTableVary vary = LayTableVary::tension;
  bool route = false;                         ///< Rows are points of a route.
  RouteTension tension = RouteTension::hold;  ///< Of a route.
  double held_tension = 0.0;                  ///< Where depth is varied and the tension is not [N].
  Assumptions assumptions;
  Findings findings;
  std::vector<LayTableRow> rows;  ///< In the order of what is varied, the limits among them.
  int solves = 0;                 ///< Equilibria calculated.
  double wall_time = 0.0;         ///< [s]
};

}  // namespace overbend
