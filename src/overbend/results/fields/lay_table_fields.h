/// Columns of a lay table; result_field.h has the idea.
#pragma once

#include "results/fields/result_field.h"
#include "results/lay_table_results.h"

namespace overbend {

template <>
struct Words<LayRowKind> {
  static constexpr WordList<LayRowKind, 3> list = {
      {{LayRowKind::step, "step"}, {LayRowKind::least, "least"}, {LayRowKind::largest, "largest"}}};
};

template <>
struct Words<LayTableVary> {
  static constexpr WordList<LayTableVary, 3> list = {
      {{LayTableVary::tension, "tension"}, {LayTableVary::lay_back, "lay_back"}, {LayTableVary::depth, "depth"}}};
};

template <>
struct Words<RouteTension> {
  static constexpr WordList<RouteTension, 2> list = {{{RouteTension::hold, "hold"}, {RouteTension::least, "least"}}};
};

/// What the row is of. `vary` and `route` decide which of the columns there are.
template <class Row, class Visit>
void visit_lay_table_place(LayTableVary vary, bool route, Row& r, Visit& visit) {
  visit(ResultField{"kind", "1", "step; or least, largest: a limit within which every governing check is passed"}
            .csv("row")
            .summary(),
        r.kind);
  if (route) {
    visit(ResultField{"distance", "m", "Along the route"}.csv("distance").summary(), r.distance);
  } else if (vary == LayTableVary::tension) {
    visit(ResultField{"tension", "N", "Tension asked for at the tensioner"}.csv("tension").summary(), r.varied);
  } else if (vary == LayTableVary::lay_back) {
    visit(ResultField{"lay_back_asked", "m", "Lay-back asked for"}.csv("lay-back asked").summary(), r.varied);
  }
  visit(ResultField{"depth", "m", "Water depth at the stern shoe"}.csv("depth").summary(), r.depth);
}

/// The lay itself.
template <class Values, class Visit>
void visit_lay_table_values(Values& r, Visit& visit) {
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.csv("top tension").summary(),
        r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.csv("bottom tension").summary(),
        r.bottom_tension);
  visit(ResultField{"lay_back", "m", "Horizontal distance from the stern shoe to touchdown"}.csv("lay-back").summary(),
        r.lay_back);
  visit(ResultField{"departure_angle", "rad", "From horizontal, at the last support in contact or the tensioner"}
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
  visit(ResultField{"largest_reaction", "N", "Of a single roller"}.csv("largest reaction").summary(),
        r.largest_reaction);
  visit(ResultField{"largest_reaction_support", "1", "Box of that roller"}.csv("at").summary(),
        r.largest_reaction_support);
  visit(ResultField{"utilisation", "1", "Of the governing check that is used most"}.csv("utilisation").summary(),
        r.utilisation);
  visit(ResultField{"worst_check", "1", "That check"}.csv("check").summary(), r.worst_check);
}

}  // namespace overbend
