/// The values of lines by themselves; result_field.h has the idea.
#pragma once

#include "results/fields/result_field.h"
#include "results/line_results.h"

namespace overbend {

/// A line at rest: a row of static.lines.
template <class Row, class Visit>
void visit_line(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary().csv("line"), r.name);
  visit(ResultField{"length", "m", "Unstressed length"}.summary(), r.length);
  visit(ResultField{"elements", "1", "Number of elements"}.summary(), r.elements);
  visit(ResultField{"weight", "N", "Submerged weight of segments, clumps and buoys"}.summary(), r.weight);
  visit(ResultField{"on_bed", "m", "Length that the bed bears"}.summary(), r.on_bed);
  visit(ResultField{"largest_tension", "N", "Largest effective tension along the line"}.summary(), r.largest_tension);
  visit(ResultField{"least_tension", "N", "Least effective tension along the line"}.summary(), r.least_tension);
  visit(ResultField{"utilisation", "1", "Largest tension over the breaking load of its segment"}.summary(),
        r.utilisation);
  visit(ResultField{"residual", "1", "Largest unbalanced force over the weight in air"}.summary(), r.residual);
  visit(ResultField{"iterations", "1", "Iterations of Newton's method"}.summary(), r.iterations);
}

/// An end at rest: static.lines[].first and second.
template <class Row, class Visit>
void visit_line_end(Row& r, Visit& visit) {
  visit(ResultField{"force", "N", "Force on the line by what holds its end", kWorldFrame}.summary(), r.force);
  visit(ResultField{"tension", "N", "Size of that force"}.summary(), r.tension);
  visit(ResultField{"declination", "rad", "Of the line at its end, positive where it hangs from it"}.summary(),
        r.declination);
}

/// A line in motion: a row of dynamic.lines.
template <class Row, class Visit>
void visit_line_in_time(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary(), r.name);
  visit(ResultField{"least_tension", "N", "Least effective tension along the line over time"}.summary(),
        r.least_tension);
  visit(ResultField{"largest_tension", "N", "Largest effective tension along the line over time"}.summary(),
        r.largest_tension);
  visit(ResultField{"utilisation", "1", "Largest tension over time over the breaking load of its segment"}.summary(),
        r.utilisation);
  visit_spread(ResultField{"first_tension", "N", "Tension at the first end, negative where it is pushed"}.summary(
                   "first_tension/*"),
               r.first_tension, visit);
  visit_spread(ResultField{"second_tension", "N", "Tension at the second end, negative where it is pushed"}.summary(
                   "second_tension/*"),
               r.second_tension, visit);
}

/// A node: a row of lines.csv.
template <class Row, class Visit>
void visit_line_node(Row& r, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed length from the first end"}.csv("s"), r.s);
  visit(ResultField{"place", "m", "Place at rest", kWorldFrame}.csv(kComponents), r.place);
  visit(ResultField{"tension", "N", "Effective tension at rest"}.csv("tension"), r.tension);
}

/// The same over time; without a run the values at rest.
template <class Visit>
void visit_line_node_in_time(double least, double largest, Visit& visit) {
  visit(ResultField{"least_tension", "N", "Least over time"}.csv("least tension"), least);
  visit(ResultField{"largest_tension", "N", "Largest over time"}.csv("largest tension"), largest);
}

}  // namespace overbend
