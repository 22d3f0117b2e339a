/// Fields of the fatigue of welds during laying; see result_field.h.
#pragma once

#include "results/fatigue_results.h"
#include "results/fields/result_field.h"

namespace overbend {

template <class Row, class Visit>
void visit_fatigue(Row& r, Visit& visit) {
  visit(ResultField{"budget", "1", "Damage budget of laying, including the design fatigue factor"}.summary(), r.budget);
  visit(ResultField{"design_factor", "1", "Design fatigue factor"}.summary(), r.design_factor);
  visit(ResultField{"lay_rate", "m/s", "Mean speed of laying"}.summary(), r.lay_rate);
  visit(ResultField{"assumptions", "1", "Assumptions"}, r.assumptions);
}

/// A spot of the weld, without its values along the line.
template <class Row, class Visit>
void visit_fatigue_spot(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Position on the weld"}.summary(), r.name);
  visit(ResultField{"curve", "1", "S-N curve of DNV-RP-C203"}.summary(), r.curve);
  visit(ResultField{"stress_factor", "1", "Hot-spot stress over the nominal stress of the wall, at the worst station"}
            .summary(),
        r.stress_factor);
  visit(ResultField{"path_damage", "1",
                    "Damage of a weld on its way from the tensioner to the seabed, without the design fatigue factor"}
            .summary(),
        r.path_damage);
  visit(ResultField{"worst_rate", "1/s", "Largest damage rate along the line"}.summary(), r.worst_rate);
  visit(ResultField{"worst_s", "m", "Arc length of that maximum from the anchor"}.summary().along(), r.worst_s);
  visit(ResultField{"standby", "s",
                    "Time that the pipe may stay in this position until the damage budget of the weld at the worst "
                    "station, including its path from the tensioner, is used up; at most 100 years"}
            .summary(),
        r.standby);
}

/// Values of a spot by station of the dynamic results.
template <class Row, class Visit>
void visit_fatigue_along(Row& r, Visit& visit) {
  visit(ResultField{"rate", "1/s", "Damage rate of the worst point round the section"}.csv("damage rate"), r.rate);
  visit(ResultField{"cycles", "1/s", "Rate of stress cycles at that point"}.csv("cycle rate"), r.cycles);
  visit(ResultField{"range", "Pa", "Nominal stress range that gives the same damage at that rate of cycles"}.csv(
            "equivalent stress range"),
        r.range);
}

}  // namespace overbend
