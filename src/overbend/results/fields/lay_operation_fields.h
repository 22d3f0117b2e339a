/// Fields of an operation on the line: its stages, the head, the cable and the start-up anchor; see result_field.h.
#pragma once

#include "results/fields/result_field.h"

namespace overbend {

/// Position of the head: `x` astern of the stern shoe, `z` from the mean water level.
template <class Row, class Visit>
void visit_head(Row& r, Visit& visit) {
  visit(ResultField{"position", "m", "Attachment point of the cable on the head's axis", kWorldFrame}
            .summary()
            .page()
            .report(),
        r.p_W);
  visit(ResultField{"astern", "m", "Distance of the head astern of the stern shoe"}
            .csv("head astern")
            .summary("x")
            .page()
            .report(),
        r.astern);
  visit(ResultField{"inclination", "rad", "Inclination of the head at the cable, positive dipping astern"}
            .csv("head inclination")
            .summary()
            .page()
            .report(),
        r.inclination);
  visit(ResultField{"cable_inclination", "rad", "Inclination of the cable at the head"}
            .csv("cable inclination")
            .summary()
            .page()
            .report(),
        r.cable_inclination);
  visit(ResultField{"tension", "N", "Effective tension of the cable at the head"}
            .csv("head tension")
            .summary()
            .page()
            .report(),
        r.tension);
  visit(ResultField{"clearance", "m", "Clearance of the head's underside above the seabed, negative for penetration"}
            .csv("head clearance")
            .summary()
            .page()
            .report(),
        r.clearance);
  visit(ResultField{"s", "m", "Arc length of the head's end from the far end of the line"}.along().page().report(),
        r.s);
}

template <class Row, class Visit>
void visit_cable(Row& r, Visit& visit) {
  visit(ResultField{"length", "m", "Unstressed length of the cable"}.summary().page().report(), r.length);
  visit(ResultField{"largest_tension", "N", "Largest effective tension of the cable"}
            .csv("cable tension")
            .summary()
            .page()
            .report(),
        r.max_tension);
  visit(ResultField{"utilisation", "1", "Maximum tension over breaking load"}
            .csv("cable utilisation")
            .summary()
            .page()
            .report(),
        r.utilisation);
  visit(ResultField{"winch_inclination", "rad", "Inclination of the cable at the winch, positive dipping astern"}
            .summary()
            .page()
            .report(),
        r.winch_inclination);
}

template <class Row, class Visit>
void visit_far_anchor(Row& r, Visit& visit) {
  visit(ResultField{"distance", "m", "Distance of the anchor astern of the stern shoe"}
            .csv("anchor distance")
            .summary()
            .page()
            .report(),
        r.distance);
  visit(ResultField{"horizontal", "N", "Horizontal pull at the anchor"}.csv("anchor pull").summary().page().report(),
        r.horizontal);
  visit(ResultField{"uplift", "N", "Upward pull at the anchor"}.csv("anchor uplift").summary().page().report(),
        r.uplift);
}

/// Input of a stage, and the tension if it was solved for.
template <class Row, class Visit>
void visit_lay_stage(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the stage"}.csv("stage").summary().page().report(), r.name);
  visit(ResultField{"cable_out", "m", "Unstressed length of the cable from winch to head"}
            .csv("cable out")
            .summary()
            .page()
            .report(),
        r.cable_out);
  visit(ResultField{"pipe_out", "m", "Unstressed length of the pipe from the tensioner to the head"}
            .csv("pipe out")
            .summary()
            .page()
            .report(),
        r.pipe_out);
  visit(ResultField{"passed", "m", "Length from the tensioner to the middle of the structure"}
            .csv("passed")
            .summary()
            .page()
            .report(),
        r.passed);
  visit(ResultField{"ahead", "m", "Distance that the vessel has moved ahead"}.csv("ahead").summary().page().report(),
        r.ahead);
  visit(ResultField{"tank_weight", "N", "Weight of the stinger's tank, empty"}
            .csv("tank weight")
            .summary("weight")
            .page("weight")
            .report("weight"),
        r.tank_weight);
  visit(ResultField{"tank_ballast", "1", "Fraction of the tank that is flooded"}
            .csv("tank ballast")
            .summary("ballast")
            .page("ballast")
            .report("ballast"),
        r.tank_ballast);
  visit(ResultField{"tension", "N", "Tension at the winch or tensioner"}.csv("tension").summary().page().report(),
        r.tension);
  visit(ResultField{"bottom_tension", "N", "Target horizontal tension at touchdown"}
            .summary("wanted_bottom_tension")
            .report("wanted_bottom_tension"),
        r.bottom_tension);
}

/// Further results of a stage.
template <class Row, class Visit>
void visit_stage_result(Row& r, Visit& visit) {
  visit(ResultField{"barge_ahead", "m", "Distance of the vessel ahead of its position in the first stage"}
            .csv("barge ahead")
            .summary()
            .page()
            .report(),
        r.barge_ahead);
  visit(ResultField{"governing", "1", "Limit that determines a solved tension; empty for a given tension"}
            .csv("decided by")
            .summary()
            .page()
            .report(),
        r.governing);
  visit(ResultField{"findings", "1", "Findings on the stage"}.summary().page().report(), r.findings);
}

/// Reason why a stage is infeasible.
template <class Row, class Visit>
void visit_stage_failure(Row& r, Visit& visit) {
  visit(ResultField{"what", "1", "What failed"}.summary().page().report(), r.what);
  visit(ResultField{"where", "1", "Where"}.summary().page().report(), r.where);
  visit(ResultField{"why", "1", "Reason, and a remedy"}.summary().page().report(), r.why);
  visit(ResultField{"least_tension", "N", "Minimum feasible top tension"}.summary().page().report(), r.min_tension);
}

/// Results of the whole operation.
template <class Row, class Visit>
void visit_operation_heading(Row& r, Visit& visit) {
  visit(ResultField{"title", "1", "Title of the model"}.summary(), r.title);
  visit(ResultField{"version", "1", "Version of the program"}.summary(), r.version);
  visit(ResultField{"assumptions", "1", "Assumptions on the operation"}.summary(), r.assumptions);
  visit(ResultField{"findings", "1", "Findings on the operation"}.summary().page(), r.findings);
}

}  // namespace overbend
