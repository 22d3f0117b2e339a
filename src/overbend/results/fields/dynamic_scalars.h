/// Single values of a dynamic analysis; see result_field.h.
#pragma once

#include "results/fields/dynamic_tables.h"
#include "results/fields/static_scalars.h"

namespace overbend {

/// Values in the group of every run.
template <class Results, class Visit>
void visit_dynamic_settings(Results& r, Visit& visit) {
  visit(ResultField{"duration", "s", "Duration from t = 0, the end of the build-up; interval of the statistics"}
            .summary()
            .report(),
        r.duration);
  visit(ResultField{"build_up", "s", "Time before t = 0 in which loads and motion are ramped up"}.summary().report(),
        r.build_up);
  visit(ResultField{"output_step", "s", "Time between the rows of the histories"}.summary(), r.output_step);
  visit(ResultField{"seed", "1", "Seed of the random phases of the sea"}.summary(), r.seed);
  visit(ResultField{"assumptions", "1", "Assumptions"}.summary(), r.assumptions);
  visit(ResultField{"findings", "1", "Findings"}.summary(), r.findings);
  visit(ResultField{"non_stationary", "1", "Reason why there are no most probable extremes; empty if there are"}
            .summary(),
        r.non_stationary);
}

/// Values of a laid pipe, in the same group. `tip` is false without a stinger.
template <class Results, class Visit>
void visit_pipe_over_time(Results& r, Visit& visit, bool tip) {
  visit(ResultField{"impact_count", "1", "Number of all impacts"}.summary(), r.impact_count);
  visit_spread(ResultField{"top_tension", "N", "Effective tension at the tensioner"}.summary(), r.top_tension, visit);
  visit_spread(ResultField{"bottom_tension", "N", "Horizontal tension at touchdown"}.summary(), r.bottom_tension,
               visit);
  visit_spread(ResultField{"lay_back", "m", "Horizontal distance from stern shoe to touchdown"}.summary(), r.lay_back,
               visit);
  visit_spread(ResultField{"departure_angle", "rad", "Departure angle from horizontal, at the last support in contact"}
                   .summary(),
               r.departure_angle, visit);
  if (!tip) return;
  visit_spread(ResultField{"stinger_tip_clearance", "m", "Separation at the last row of the stinger"}.summary(),
               r.stinger_tip_clearance, visit);
}

template <class Results, class Visit>
void visit_dynamic_keys(Results& r, Visit& visit, bool tip) {
  visit_dynamic_settings(r, visit);
  visit_pipe_over_time(r, visit, tip);
}

/// The four extremes of a region: visit_extreme(field, extreme).
template <class RegionType, class VisitExtreme>
void visit_dynamic_region(RegionType& r, VisitExtreme&& visit_extreme) {
  visit_extreme(ResultField{"bending_moment", "N m", "Largest bending moment of the region"}
                    .summary("max_bending_moment")
                    .report(),
                r.bending_moment);
  visit_extreme(
      ResultField{"bending_stress", "Pa", "Largest bending stress of the region"}.summary("max_bending_stress"),
      r.bending_stress);
  visit_extreme(ResultField{"strain", "1", "Largest strain of the region"}.summary("max_strain").report(), r.strain);
  visit_extreme(
      ResultField{"von_mises", "Pa", "Largest von Mises stress of the region"}.summary("max_von_mises").report(),
      r.von_mises);
}

/// Position and time of the extreme.
template <class Row, class Visit>
void visit_instant_of_extreme(Row& r, Visit& visit) {
  visit(ResultField{"s", "m", "Arc length of the overall extreme from the anchor"}.along().summary("at/s").report(),
        r.s);
  visit(ResultField{"position", "m", "Position of that station in the static state", kWorldFrame}.summary("at/"),
        r.p_W);
  visit(ResultField{"time", "s", "Time of the overall extreme"}.summary().report(), r.time);
}

/// `of`: the field of the extreme, from visit_dynamic_region.
template <class Row, class Visit>
void visit_dynamic_extreme(const ResultField& of, Row& r, Visit& visit) {
  visit_spread(ResultField{"", of.units, of.description}.summary("*"), r.over_time, visit);
  visit_instant_of_extreme(r, visit);
}

template <class Row, class Visit>
void visit_energy(Row& r, Visit& visit) {
  visit(ResultField{"kinetic", "J", "Kinetic energy, change since the start"}, r.kinetic);
  visit(ResultField{"strain", "J", "Strain energy of the pipe, change since the start"}, r.strain);
  visit(ResultField{"gravity", "J", "Energy of weight and buoyancy, change since the start"}, r.gravity);
  visit(ResultField{"contact", "J", "Energy stored in the contacts with rollers, change since the start"}, r.contact);
  visit(ResultField{"seabed", "J", "Energy stored in the seabed, change since the start"}, r.seabed);
  visit(ResultField{"fluid", "J", "Work of the water on the pipe"}, r.fluid);
  visit(ResultField{"rollers", "J", "Work of the moving rollers on the pipe"}, r.rollers);
  visit(ResultField{"top", "J", "Work of the tensioner on the pipe"}, r.top);
  visit(ResultField{"anchor", "J", "Work of the anchor on the pipe"}, r.anchor);
  visit(ResultField{"contact_loss", "J", "Lost in the damping of the contacts"}, r.contact_loss);
  visit(ResultField{"friction_loss", "J", "Lost in friction"}, r.friction_loss);
  visit(ResultField{"seabed_loss", "J", "Lost in the seabed"}, r.seabed_loss);
  visit(ResultField{"yielding_loss", "J", "Lost in yielding steel"}, r.yielding_loss);
  visit(ResultField{"line_loss", "J", "Lost in the internal damping of ropes and chains"}, r.line_loss);
  visit(ResultField{"bodies", "J", "Kinetic and potential energy of a free hull or stinger, change since the start"},
        r.bodies);
  visit(ResultField{"on_bodies", "J", "Work of waves, water, wind, machines and loads on a free hull or stinger"},
        r.on_bodies);
  visit(ResultField{"error", "J", "Stored plus dissipated energy minus the work done"}, r.error);
  visit(ResultField{"throughput", "J", "Sum of the absolute work and losses"}, r.throughput);
}

template <class Row, class Visit>
void visit_tensioner(Row& r, Visit& visit) {
  visit(ResultField{"mode", "1", "Mode of the machine"}.summary(), r.mode);
  visit(ResultField{"wanted", "N", "Set tension"}.summary(), r.wanted);
  visit(ResultField{"range_low", "N", "Operational range, from; 0 without one"}.summary(), r.range_low);
  visit(ResultField{"range_high", "N", "Operational range, to; 0 without one"}.summary(), r.range_high);
  visit(ResultField{"travel_limit", "m", "Maximum travel in both directions; 0 without a limit"}.summary(),
        r.travel_limit);
  visit_spread(ResultField{"tension", "N", "Force of the tensioner on the pipe along its guide"}.summary("*_tension"),
               r.tension, visit);
  visit_spread(ResultField{"travel", "m", "Length paid out since the start, hauled in negative"}.summary("travel_*"),
               r.travel, visit);
  visit(ResultField{"time_out_of_range", "s", "Time with the tension outside the range set"}.summary(),
        r.time_out_of_range);
  visit(ResultField{"time_holding", "s", "Time holding, with the tension in its range"}.summary(), r.time_holding);
  visit(ResultField{"time_delayed", "s", "Time between leaving the range and moving"}.summary(), r.time_delayed);
  visit(ResultField{"time_paying_out", "s", "Time paying out"}.summary(), r.time_paying_out);
  visit(ResultField{"time_hauling_in", "s", "Time hauling in"}.summary(), r.time_hauling_in);
  visit(ResultField{"time_at_limit", "s", "Time at a limit of the machine"}.summary(), r.time_at_limit);
  visit(ResultField{"pay_out_count", "1", "Number of times the machine has paid out"}.summary(), r.pay_out_count);
  visit(ResultField{"haul_in_count", "1", "Number of times the machine has hauled in"}.summary(), r.haul_in_count);
  visit(ResultField{"limit_count", "1", "Number of times it reached its travel limit"}.summary(), r.limit_count);
}

template <class Row, class Visit>
void visit_dynamic_run(Row& r, Visit& visit) {
  visit(ResultField{"steps", "1", "Time steps"}.summary(), r.steps);
  visit(ResultField{"rejected_steps", "1", "Steps repeated with a smaller step size"}.summary(), r.rejected_steps);
  visit(ResultField{"newton_iterations", "1", "Newton iterations"}.summary(), r.newton_iterations);
  visit(ResultField{"factorisations", "1", "Factorisations of the tangent matrix"}.summary(), r.factorisations);
  visit(ResultField{"smallest_step", "s", "Smallest time step"}.summary(), r.min_step_taken);
  visit(ResultField{"largest_step", "s", "Largest time step"}.summary(), r.max_step_taken);
  visit(ResultField{"wall_time", "s", "Wall time of the time loop, summed over all restarts"}.summary(), r.wall_time);
  visit(ResultField{"real_time_ratio", "1", "Simulated time over wall time"}.summary(), r.real_time_ratio);
  visit(ResultField{"integrator", "1", "Time integration scheme"}.summary(), r.integrator);
}

}  // namespace overbend
