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

/// Type of a row.
enum class LayRowKind {
  step,     ///< One of the requested values.
  minimum,  ///< The minimum value of the varied quantity with which every governing check passes.
  maximum,  ///< The maximum of these values.
};

/// Values of an equilibrium in a lay table.
struct LayTableValues {
  double top_tension = 0.0;              ///< Effective, at the tensioner [N].
  double bottom_tension = 0.0;           ///< Horizontal, at touchdown [N].
  double lay_back = 0.0;                 ///< Stern shoe to touchdown [m].
  double departure_angle = 0.0;          ///< At the last support in contact; at the tensioner in J-lay [rad].
  std::optional<double> tip_separation;  ///< At the last row of the stinger [m].
  double overbend_bending_stress = 0.0;  ///< Maximum; of the tower in J-lay [Pa].
  double overbend_von_mises = 0.0;       ///< Maximum; of the tower in J-lay [Pa].
  double overbend_strain = 0.0;          ///< Maximum; of the tower in J-lay [-].
  double sagbend_bending_stress = 0.0;   ///< [Pa]
  double sagbend_von_mises = 0.0;        ///< [Pa]
  double sagbend_strain = 0.0;           ///< [-]
  double max_reaction = 0.0;             ///< Maximum of a single roller [N].
  std::string max_reaction_support;      ///< Roller box of that maximum.
  std::optional<double> utilisation;     ///< Maximum of the governing checks; none if none is judged.
  std::string find_governing_check;      ///< Name of that check.
  std::string tip;                       ///< If the check is of the stinger tip: the box where the free end begins.
  VerdictKind verdict = VerdictKind::not_judged;

  bool passed() const { return verdict == VerdictKind::passed; }
};

struct LayTableRow {
  LayRowKind kind = LayRowKind::step;
  double varied = 0.0;                ///< Tension [N], lay-back or depth [m], as given or as solved for.
  std::optional<double> distance;     ///< Along the route [m].
  double depth = 0.0;                 ///< Water depth [m].
  std::optional<LayTableValues> lay;  ///< None without an equilibrium.
  std::string reason;                 ///< Reason for a missing equilibrium, exceeded check, or limit of the range; may
                                      ///< be empty.
  Findings serious;                   ///< Serious findings outside the checks: a pipe off its rollers, formulas outside
                                      ///< their validity.
  int solves = 0;                     ///< Number of equilibria solved.
};

/// Returns the reason and the serious findings in one text.
inline std::string make_remark(const LayTableRow& row) {
  std::string remark = row.reason;
  if (row.lay && !row.lay->tip.empty()) remark += (remark.empty() ? "" : "; ") + row.lay->tip;
  for (const Finding& finding : row.serious) remark += (remark.empty() ? "" : "; ") + finding.message;
  return remark;
}

struct LayTable {
  std::string title, version;
  LayTableVary vary = LayTableVary::tension;
  bool route = false;                         ///< True if the rows are points of a route.
  RouteTension tension = RouteTension::hold;  ///< Tension program along a route.
  double held_tension = 0.0;                  ///< Tension kept constant while the depth varies [N].
  Assumptions assumptions;
  Findings findings;
  std::vector<LayTableRow> rows;  ///< In the order of the varied quantity, including the limits.
  int solves = 0;                 ///< Number of equilibria solved.
  double wall_time = 0.0;         ///< [s]
};

}  // namespace overbend
