/// Fields of stand-alone lines; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/line_results.h"

namespace overbend {

/// Static results of a line: a row of static.lines.
template <class Row, class Visit>
void visit_line(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary().csv("line"), r.name);
  visit(ResultField{"length", "m", "Unstressed length"}.summary(), r.length);
  visit(ResultField{"elements", "1", "Number of elements"}.summary(), r.elements);
  visit(ResultField{"weight", "N", "Submerged weight of segments, clumps and buoys"}.summary(), r.weight);
  visit(ResultField{"on_bed", "m", "Length in contact with the seabed"}.summary(), r.on_bed);
  visit(ResultField{"largest_tension", "N", "Largest effective tension along the line"}.summary(), r.max_tension);
  visit(ResultField{"least_tension", "N", "Minimum effective tension along the line"}.summary(), r.min_tension);
  visit(ResultField{"utilisation", "1", "Largest tension over the breaking load of its segment"}.summary(),
        r.utilisation);
  visit(ResultField{"residual", "1", "Largest unbalanced force over the weight in air"}.summary(), r.residual);
  visit(ResultField{"iterations", "1", "Iterations of Newton's method"}.summary(), r.iterations);
}

/// Static results of a line end: static.lines[].first and second.
template <class Row, class Visit>
void visit_line_end(Row& r, Visit& visit) {
  visit(ResultField{"force", "N", "Force on the line from its attachment", kWorldFrame}.summary(), r.force);
  visit(ResultField{"tension", "N", "Magnitude of that force"}.summary(), r.tension);
  visit(
      ResultField{"declination", "rad", "Angle of the line below horizontal at its end, positive if suspended from it"}
          .summary(),
      r.declination);
}

/// Results of a line over time: a row of dynamic.lines.
template <class Row, class Visit>
void visit_line_in_time(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary(), r.name);
  visit(ResultField{"least_tension", "N", "Minimum effective tension along the line over time"}.summary(),
        r.min_tension);
  visit(ResultField{"largest_tension", "N", "Largest effective tension along the line over time"}.summary(),
        r.max_tension);
  visit(ResultField{"utilisation", "1", "Largest tension over time over the breaking load of its segment"}.summary(),
        r.utilisation);
  visit_spread(ResultField{"first_tension", "N", "Tension at the first end, negative for compression"}.summary(
                   "first_tension/*"),
               r.first_tension, visit);
  visit_spread(ResultField{"second_tension", "N", "Tension at the second end, negative for compression"}.summary(
                   "second_tension/*"),
               r.second_tension, visit);
}

/// A node: a row of lines.csv.
template <class Row, class Visit>
void visit_line_node(Row& r, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed length from the first end"}.csv("s"), r.s);
  visit(ResultField{"place", "m", "Position in equilibrium", kWorldFrame}.csv(kComponents), r.place);
  visit(ResultField{"tension", "N", "Static effective tension"}.csv("tension"), r.tension);
}

/// Extremes over time; static values without a run.
template <class Visit>
void visit_line_node_in_time(double min_tension, double max_tension, Visit& visit) {
  visit(ResultField{"least_tension", "N", "Minimum over time"}.csv("least tension"), min_tension);
  visit(ResultField{"largest_tension", "N", "Maximum over time"}.csv("largest tension"), max_tension);
}

}  // namespace overbend
