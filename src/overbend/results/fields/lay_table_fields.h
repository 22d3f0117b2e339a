/// Columns of a lay table; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/lay_table_results.h"

namespace overbend {

template <>
struct ResultEnumNames<LayRowKind> {
  static constexpr ResultEnumNameList<LayRowKind, 3> list = {
      {{LayRowKind::step, "step"}, {LayRowKind::minimum, "least"}, {LayRowKind::maximum, "largest"}}};
};

template <>
struct ResultEnumNames<LayTableVary> {
  static constexpr ResultEnumNameList<LayTableVary, 3> list = {
      {{LayTableVary::tension, "tension"}, {LayTableVary::lay_back, "lay_back"}, {LayTableVary::depth, "depth"}}};
};

template <>
struct ResultEnumNames<RouteTension> {
  static constexpr ResultEnumNameList<RouteTension, 2> list = {
      {{RouteTension::hold, "hold"}, {RouteTension::minimum, "least"}}};
};

/// Input of the row. `vary` and `route` decide which of the columns exist.
template <class Row, class Visit>
void visit_lay_table_place(LayTableVary vary, bool route, Row& r, Visit& visit) {
  visit(ResultField{"kind", "1", "step; or least, largest: a limit within which every governing check passes"}
            .csv("row")
            .summary(),
        r.kind);
  if (route) {
    visit(ResultField{"distance", "m", "Distance along the route"}.csv("distance").summary(), r.distance);
  } else if (vary == LayTableVary::tension) {
    visit(ResultField{"tension", "N", "Requested tension at the tensioner"}.csv("tension").summary(), r.varied);
  } else if (vary == LayTableVary::lay_back) {
    visit(ResultField{"lay_back_asked", "m", "Requested lay-back"}.csv("lay-back asked").summary(), r.varied);
  }
  visit(ResultField{"depth", "m", "Water depth at the stern shoe"}.csv("depth").summary(), r.depth);
}

/// Results of the lay.
template <class Values, class Visit>
void visit_lay_table_values(Values& r, Visit& visit) {
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.csv("top tension").summary(),
        r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.csv("bottom tension").summary(),
        r.bottom_tension);
  visit(ResultField{"lay_back", "m", "Horizontal distance from the stern shoe to touchdown"}.csv("lay-back").summary(),
        r.lay_back);
  visit(ResultField{"departure_angle", "rad",
                    "Departure angle from horizontal, at the last support in contact or "
                    "the tensioner"}
            .csv("departure angle")
            .summary(),
        r.departure_angle);
  visit(ResultField{"stinger_tip_clearance", "m", "Separation at the last row of the stinger"}
            .csv("tip separation")
            .summary(),
        r.tip_separation);
  visit(ResultField{"overbend_bending_stress", "Pa", "Largest bending stress of the overbend, or the tower"}
            .csv("overbend bending stress")
            .summary(),
        r.overbend_bending_stress);
  visit(ResultField{"overbend_von_mises", "Pa", "Largest von Mises stress there"}
            .csv("overbend von Mises stress")
            .summary(),
        r.overbend_von_mises);
  visit(ResultField{"overbend_strain", "1", "Largest strain there"}.csv("overbend strain").summary(),
        r.overbend_strain);
  visit(ResultField{"sagbend_bending_stress", "Pa", "Largest bending stress of the sagbend"}
            .csv("sagbend bending stress")
            .summary(),
        r.sagbend_bending_stress);
  visit(ResultField{"sagbend_von_mises", "Pa", "Largest von Mises stress there"}
            .csv("sagbend von Mises stress")
            .summary(),
        r.sagbend_von_mises);
  visit(ResultField{"sagbend_strain", "1", "Largest strain there"}.csv("sagbend strain").summary(), r.sagbend_strain);
  visit(ResultField{"largest_reaction", "N", "Maximum reaction of a single roller"}.csv("largest reaction").summary(),
        r.max_reaction);
  visit(ResultField{"largest_reaction_support", "1", "Box of that roller"}.csv("at").summary(), r.max_reaction_support);
  visit(ResultField{"utilisation", "1", "Maximum utilisation of the governing checks"}.csv("utilisation").summary(),
        r.utilisation);
  visit(ResultField{"worst_check", "1", "Name of that check"}.csv("check").summary(), r.find_governing_check);
}

}  // namespace overbend
