/// Fields of the tables of a dynamic analysis; see result_field.h.
#pragma once

#include "results/dynamic_results.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Fields common to the tables of supports and of rollers.
template <class Row, class Visit>
void visit_contact_over_time(Row& r, Visit& visit) {
  visit_spread(ResultField{"separation", "m", "Clear distance, daylight positive"}.csv("separation").summary().page(),
               r.separation, visit);
  visit(ResultField{"static_reaction", "N", "Reaction in the static state"}.report(), r.static_reaction);
  visit(ResultField{"static_separation", "m", "Clear distance in the static state"}, r.static_separation);
  visit(ResultField{"contact_share", "1", "Fraction of the time in contact"}
            .csv("contact share [-]")
            .si()
            .summary()
            .report(),
        r.contact_share);
  visit(ResultField{"impact_count", "1", "Number of impacts"}.csv("impacts").summary("impacts").report(),
        r.impact_count);
}

template <class Row, class Visit>
void visit_dynamic_support(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the roller box"}.summary().report(), r.name);
  visit(ResultField{"stinger", "1", "1 on the stinger, 0 on the ramp"}, r.stinger);
  visit(ResultField{"s", "m", "Arc length of the pipe at the middle of the box in the static state"}.along().summary(),
        r.s);
  visit_spread(ResultField{"reaction", "N", "Resultant of all rollers on the pipe, magnitude"}.summary(), r.reaction,
               visit);
  visit(
      ResultField{"reaction_p50", "N", "50th percentile of the reaction over time"}.summary("reaction_percentiles/p50"),
      r.reaction_over_time.p50);
  visit(
      ResultField{"reaction_p90", "N", "90th percentile of the reaction over time"}.summary("reaction_percentiles/p90"),
      r.reaction_over_time.p90);
  visit(
      ResultField{"reaction_p99", "N", "99th percentile of the reaction over time"}.summary("reaction_percentiles/p99"),
      r.reaction_over_time.p99);
  visit_spread(ResultField{"vertical", "N", "Vertical part of the resultant", kWorldFrame}.summary(), r.vertical,
               visit);
  visit_spread(ResultField{"longitudinal", "N", "Part of the resultant along the box axis, astern positive", kBoxFrame}
                   .summary(),
               r.longitudinal, visit);
  visit_spread(ResultField{"lateral", "N", "Part of the resultant across, port positive", kBoxFrame}.summary(),
               r.lateral, visit);
  visit_contact_over_time(r, visit);
  visit(ResultField{"left_to_port", "s", "Time at which the pipe first left the box over its port end"}.summary(),
        r.left_to_port);
  visit(ResultField{"left_to_starboard", "s", "Time at which the pipe first left the box over its starboard end"}
            .summary(),
        r.left_to_starboard);
}

/// Peak values of a roller.
template <class Row, class Visit>
void visit_hardest(Row& r, Visit& visit) {
  visit(ResultField{"largest_impact_force", "N", "Largest force of an impact"}.csv("largest impact force").summary(),
        r.max_impact_force);
  visit(ResultField{"largest_approach_velocity", "m/s", "Largest normal velocity at first touch"}
            .csv("largest approach velocity")
            .summary(),
        r.max_approach_velocity);
  visit(ResultField{"largest_impulse", "N s", "Largest impulse of an impact"}.csv("largest impulse").summary(),
        r.max_impulse);
  visit(ResultField{"dent_depth", "m", "Dent of bare steel under the largest force"}.csv("dent depth").summary(),
        r.dent_depth);
  visit(ResultField{"line_load", "N/m", "Largest force divided by the length of coating under the roller"}
            .csv("line load")
            .summary(),
        r.line_load);
}

template <class Row, class Visit>
void visit_dynamic_roller(Row& r, Visit& visit) {
  visit(ResultField{"roller", "1", "Number of the roller through all boxes, from 0"}, r.roller);
  visit(ResultField{"box", "1", "Number of its box, from 0"}, r.box);
  visit(ResultField{"row", "1", "Number of its row within the box, from 0"}, r.row);
  visit(ResultField{"position", "1", "Position in the row: bottom, port or starboard"}, r.position);
  visit_spread(
      ResultField{"reaction", "N", "Normal contact force on the pipe"}.csv("reaction normal").summary().report(),
      r.reaction, visit);
  visit_contact_over_time(r, visit);
  visit_hardest(r, visit);
}

template <class Row, class Visit>
void visit_impact(Row& r, Visit& visit) {
  visit(ResultField{"time", "s", "Time of first touch"}.csv("time").page().report(), r.time);
  visit(ResultField{"roller", "1", "Number of the roller through all boxes, from 0"}, r.roller);
  visit(ResultField{"approach_velocity", "m/s", "Normal velocity at first touch"}
            .csv("approach velocity")
            .page()
            .report(),
        r.approach_velocity);
  visit(ResultField{"peak_force", "N", "Largest normal force"}.csv("peak force").page().report(), r.peak_force);
  visit(ResultField{"duration", "s",
                    "Duration until separation, or until the force has passed its peak if the pipe stays in contact"}
            .csv("duration")
            .page(),
        r.duration);
  visit(ResultField{"impulse", "N s", "Integral of the normal force over the duration"}.csv("impulse").page(),
        r.impulse);
  visit(ResultField{"dent_depth", "m", "Dent of bare steel under the peak force"}.csv("dent depth").page(),
        r.dent_depth);
  visit(ResultField{"line_load", "N/m", "Peak force divided by the length of coating under the roller"}
            .csv("line load")
            .page(),
        r.line_load);
}

template <class Row, class Visit>
void visit_estimate(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the history"}.summary(), r.name);
  visit(ResultField{"units", "1", "Units of its values"}.summary(), r.units);
  visit(ResultField{"smallest", "1", "1 if the extremes are minima, 0 if they are maxima"}.summary(), r.is_minimum);
  visit(ResultField{"peaks", "1", "Number of peaks between mean up-crossings, from t = 0"}.summary(), r.peaks);
  visit(ResultField{"observed", kVaries, "Largest (smallest) value of the run"}.summary(), r.observed);
  visit(ResultField{"estimate", kVaries, "Most probable largest (smallest) value in three hours"}.summary(),
        r.estimate);
  visit(ResultField{"low", kVaries, "Lower bound of it at 95 % confidence"}.summary(), r.low);
  visit(ResultField{"high", kVaries, "Upper bound of it at 95 % confidence"}.summary(), r.high);
  visit(ResultField{"method", "1", "Method of the estimate"}.summary(), r.method);
  visit(ResultField{"quality", "1", "good, uncertain, or none: no reliable estimate"}.summary(), r.quality);
  visit(ResultField{"remark", "1", "Reason if the quality is not good"}.summary(), r.remark);
  visit(ResultField{"weibull", kVaries, "Weibull fit; none if it does not describe the peaks"}.summary(
            "weibull/estimate"),
        r.weibull);
  visit(ResultField{"weibull_low", kVaries, "Lower bound of it at 95 % confidence"}.summary("weibull/low"),
        r.weibull_low);
  visit(ResultField{"weibull_high", kVaries, "Upper bound of it at 95 % confidence"}.summary("weibull/high"),
        r.weibull_high);
  visit(ResultField{"gumbel", kVaries, "Gumbel fit"}.summary("gumbel/estimate"), r.gumbel);
  visit(ResultField{"gumbel_low", kVaries, "Lower bound of it at 95 % confidence"}.summary("gumbel/low"), r.gumbel_low);
  visit(ResultField{"gumbel_high", kVaries, "Upper bound of it at 95 % confidence"}.summary("gumbel/high"),
        r.gumbel_high);
  visit(ResultField{"pareto", kVaries, "Generalised Pareto fit; none if the Weibull fit is used"}.summary(
            "pareto/estimate"),
        r.pareto);
  visit(ResultField{"pareto_low", kVaries, "Lower bound of it at 95 % confidence"}.summary("pareto/low"), r.pareto_low);
  visit(ResultField{"pareto_high", kVaries, "Upper bound of it at 95 % confidence"}.summary("pareto/high"),
        r.pareto_high);
  visit(ResultField{"enough", "1", "0: too few peaks to fit"}.summary(), r.enough);
}

/// A quantity along the line over time, and its static values. Visitors with a member `over_time` receive both
/// together.
template <class EnvelopeType, class List, class Visit>
void visit_over_time(const ResultField& field, const ResultField& before, EnvelopeType& envelope, List& statics,
                     Visit& visit) {
  if constexpr (requires { visit.over_time(field, envelope, statics); }) {
    visit.over_time(field, envelope, statics);
  } else {
    visit(before, statics);
    visit_spread(field, envelope, visit);
  }
}

/// Columns by station: visit(field, numbers) and visit(field, places).
template <class Results, class Visit>
void visit_dynamic_stations(Results& r, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed arc length from the anchor"}.along().page().report(), r.station_s);
  visit(ResultField{"static", "m", "Position in the static state", kWorldFrame}.page(kComponents), r.static_place);
  visit_over_time(ResultField{"effective_tension", "N", "Effective tension"}.csv("tension").page().report(),
                  ResultField{"static_tension", "N", "Effective tension in the static state"}, r.effective_tension,
                  r.static_tension, visit);
  visit_over_time(
      ResultField{"bending_moment", "N m", "Bending moment, magnitude"}.csv("bending moment").page().report(),
      ResultField{"static_moment", "N m", "Bending moment in the static state"}, r.bending_moment, r.static_moment,
      visit);
  visit_over_time(ResultField{"bending_stress", "Pa", "Bending stress at the outer fibre of the steel"}
                      .csv("bending stress")
                      .page(),
                  ResultField{"static_bending_stress", "Pa", "Bending stress in the static state"}, r.bending_stress,
                  r.static_bending_stress, visit);
  visit_over_time(ResultField{"von_mises", "Pa", "Largest von Mises stress over the section"}
                      .csv("von Mises stress")
                      .page()
                      .report(),
                  ResultField{"static_von_mises", "Pa", "Largest von Mises stress of the section in the static state"},
                  r.von_mises, r.static_von_mises, visit);
  visit_over_time(ResultField{"strain", "1", "Largest longitudinal strain magnitude at the outer fibre"}
                      .csv("strain")
                      .page()
                      .report(),
                  ResultField{"static_strain", "1", "Largest strain of the section in the static state"}, r.strain,
                  r.static_strain, visit);
  visit_spread(ResultField{"x", "m", "Place", kWorldFrame}, r.x, visit);
  visit_spread(ResultField{"y", "m", "Place", kWorldFrame}, r.y, visit);
  visit_spread(ResultField{"z", "m", "Place", kWorldFrame}, r.z, visit);
}

}  // namespace overbend
