/// Fields of the laid pipe on an uneven seabed; see result_field.h. Positions are measured astern of the stern shoe.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

/// Start and end of a stretch of the laid pipe.
template <class Row, class Visit>
void visit_bed_stretch(Row& r, Visit& visit) {
  visit(ResultField{"x_from", "m", "Start of the stretch"}.csv("from").summary().page().report(), r.x_from);
  visit(ResultField{"x_to", "m", "End of the stretch"}.csv("to").summary().page().report(), r.x_to);
  visit(ResultField{"s_from", "m", "Arc length of its start from the far end"}.along().summary().page().report(),
        r.s_from);
  visit(ResultField{"s_to", "m", "Arc length of its end from the far end"}.along().summary().page().report(), r.s_to);
}

template <class Row, class Visit>
void visit_bed_contact(Row& r, Visit& visit) {
  visit_bed_stretch(r, visit);
  visit(ResultField{"largest_penetration", "m", "Largest penetration of the seabed"}
            .summary("max_penetration")
            .page()
            .report(),
        r.max_penetration);
}

template <class Row, class Visit>
void visit_free_span(Row& r, Visit& visit) {
  visit_bed_stretch(r, visit);
  visit(ResultField{"length", "m", "Unstressed length"}.csv("length").summary().page().report(), r.length);
  visit(ResultField{"largest_gap", "m", "Maximum gap between underside and seabed, normal to the seabed"}
            .csv("largest gap")
            .summary("max_gap")
            .page()
            .report(),
        r.max_gap);
  visit(ResultField{"gap_x", "m", "Position of that maximum"}.csv("gap at").summary("max_gap_x").page().report(),
        r.gap_x);
  visit(ResultField{"sagging_moment", "N m", "Largest sagging moment"}
            .csv("sagging moment")
            .summary("max_sagging_moment")
            .page()
            .report(),
        r.sagging_moment);
  visit(ResultField{"moment_x", "m", "Position of that maximum"}
            .csv("moment at")
            .summary("max_sagging_moment_x")
            .page()
            .report(),
        r.moment_x);
  visit(ResultField{"bending_stress", "Pa", "Largest bending stress"}
            .csv("bending stress")
            .summary("max_bending_stress")
            .page()
            .report(),
        r.bending_stress);
}

template <class Row, class Visit>
void visit_bed_height(Row& r, Visit& visit) {
  visit(ResultField{"x", "m", "Distance astern of the stern shoe"}.page().report(), r.x);
  visit(ResultField{"z", "m", "Height of the seabed there"}.page().report(), r.z);
}

/// Single values of the laid pipe on the seabed.
template <class Row, class Visit>
void visit_laid_pipe(Row& r, Visit& visit) {
  visit(ResultField{"largest_penetration", "m", "Largest penetration of the seabed"}
            .summary("max_penetration")
            .page()
            .report(),
        r.max_penetration);
  visit(ResultField{"penetration_x", "m", "Position of that maximum"}.summary("max_penetration_x").page().report(),
        r.penetration_x);
  visit(ResultField{"hogging_moment", "N m", "Largest hogging moment of the laid pipe"}
            .summary("max_hogging_moment/value")
            .page()
            .report(),
        r.hogging_moment);
  visit(ResultField{"hogging_x", "m", "Position of that maximum"}.summary("max_hogging_moment/x").page().report(),
        r.hogging_x);
  visit(ResultField{"sagging_moment", "N m", "Largest sagging moment of the laid pipe"}
            .summary("max_sagging_moment/value")
            .page()
            .report(),
        r.sagging_moment);
  visit(ResultField{"sagging_x", "m", "Position of that maximum"}.summary("max_sagging_moment/x").page().report(),
        r.sagging_x);
  visit(ResultField{"bending_stress", "Pa", "Largest bending stress of the laid pipe"}
            .summary("max_bending_stress")
            .page()
            .report(),
        r.bending_stress);
  visit(ResultField{"tail_tension", "N", "Effective tension at the far end"}.summary().page().report(), r.tail_tension);
}

}  // namespace overbend
