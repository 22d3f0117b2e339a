/// Fatigue of welds while the pipe is laid; result_field.h has the idea.
#pragma once

#include "results/fatigue_results.h"
#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_fatigue(Row& r, Visit& visit) {
  visit(ResultField{"budget", "1", "Damage that laying may use up, with the design fatigue factor"}.summary(),
        r.budget);
  visit(ResultField{"design_factor", "1", "Design fatigue factor"}.summary(), r.design_factor);
  visit(ResultField{"lay_rate", "m/s", "Mean speed of laying"}.summary(), r.lay_rate);
  visit(ResultField{"assumptions", "1", "What was assumed"}, r.assumptions);
}

/// A spot of the weld, without what it has along the line.
template <class Row, class Visit>
void visit_fatigue_spot(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Place of the weld"}.summary(), r.name);
  visit(ResultField{"curve", "1", "S-N curve of DNV-RP-C203"}.summary(), r.curve);
  visit(ResultField{"stress_factor", "1", "Stress there over the nominal stress of the wall, at the worst station"}
            .summary(),
        r.stress_factor);
  visit(ResultField{"path_damage", "1",
                    "Damage of a weld on its way from the tensioner to the bed, without the design fatigue factor"}
            .summary(),
        r.path_damage);
  visit(ResultField{"worst_rate", "1/s", "Largest damage rate along the line"}.summary(), r.worst_rate);
  visit(ResultField{"worst_s", "m", "Where, from the anchor"}.summary().along(), r.worst_s);
  visit(
      ResultField{"standby", "s",
                  "Time that the pipe may wait as it lies until the budget of the weld at the worst station, which has "
                  "yet to go or has gone its way, is used up; at most 100 years"}
          .summary(),
      r.standby);
}

/// Of a spot, by station of the dynamic results.
template <class Row, class Visit>
void visit_fatigue_along(Row& r, Visit& visit) {
  visit(ResultField{"rate", "1/s", "Damage rate of the worst point round the section"}.csv("damage rate"), r.rate);
  visit(ResultField{"cycles", "1/s", "Rate of stress cycles at that point"}.csv("cycle rate"), r.cycles);
  visit(ResultField{"range", "Pa", "Nominal stress range that gives the same damage at that rate of cycles"}.csv(
            "equivalent stress range"),
        r.range);
}

}  // namespace overbend
