/// Fields of the positions of a pull-ahead; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/mooring_results.h"

namespace overbend {

template <class Row, class Visit>
void visit_move_step(Row& r, Visit& visit) {
  visit(ResultField{"advance", "m", "Distance of the hull along its path from the start"}.csv("advance").summary(),
        r.advance);
}

template <class Row, class Visit>
void visit_anchor_due(Row& r, Visit& visit) {
  visit(ResultField{"joint", "1", "Joint before which the anchor is moved, counted from 1"}.csv("joint").summary(),
        r.joint);
  visit(ResultField{"line", "1", "Line whose anchor is moved"}.csv("line").summary(), r.line);
  visit(ResultField{"reason", "1", "Limit of its useful range that would be exceeded"}.csv("reason").summary(),
        r.reason);
  visit(ResultField{"from", "m", "Old position of the anchor", kWorldFrame}.summary(), r.from_W);
  visit(ResultField{"to", "m", "New position of the anchor", kWorldFrame}.summary(), r.to_W);
  visit(ResultField{"length", "m", "Unstressed length of the line at its new position"}.csv("length").summary(),
        r.length);
}

/// The pipe at one position.
template <class Row, class Visit>
void visit_pipe_at_step(Row& r, Visit& visit) {
  visit(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.csv("top tension").summary(),
        r.top_tension);
  visit(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.csv("bottom tension").summary(),
        r.bottom_tension);
  visit(ResultField{"overbend_bending_stress", "Pa", "Largest bending stress of the overbend, or the tower"}
            .csv("overbend bending stress")
            .summary(),
        r.overbend_bending_stress);
  visit(ResultField{"overbend_strain", "1", "Largest strain there"}.csv("overbend strain").summary(),
        r.overbend_strain);
  visit(ResultField{"sagbend_bending_stress", "Pa", "Largest bending stress of the sagbend"}
            .csv("sagbend bending stress")
            .summary(),
        r.sagbend_bending_stress);
  visit(ResultField{"sagbend_strain", "1", "Largest strain there"}.csv("sagbend strain").summary(), r.sagbend_strain);
  visit(ResultField{"largest_reaction", "N", "Maximum reaction of a single roller"}.csv("largest reaction").summary(),
        r.max_reaction);
  visit(ResultField{"largest_reaction_support", "1", "Box of that roller"}.csv("at").summary(), r.max_reaction_support);
  visit(ResultField{"lay_back", "m", "Horizontal distance from the stern shoe to touchdown"}.csv("lay-back").summary(),
        r.lay_back);
}

}  // namespace overbend
