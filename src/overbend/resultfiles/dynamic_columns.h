/// The columns of the tables of a dynamic analysis; see static_columns.h for the idea.
#pragma once

#include "resultfiles/result_field.h"
#include "results/dynamic_results.h"

namespace overbend {

/// The four values of a quantity over time: top_tension_min and so on; of a field without a name: min.
template <class SpreadType, class Visit>
void visit_spread(const ResultField& f, SpreadType& spread, Visit& visit) {
  const auto part = [&](const char* name, const char* description) {
    return ResultField{f.name.empty() ? name : f.name + "_" + name, f.units, f.description + ", " + description,
                       f.frame};
  };
  visit(part("min", "least"), spread.min);
  visit(part("max", "largest"), spread.max);
  visit(part("mean", "mean over time"), spread.mean);
  visit(part("std", "standard deviation over time"), spread.std);
}

/// What the tables of supports and of rollers share.
template <class Row, class Visit>
void visit_contact_over_time(Row& r, Visit& visit) {
  visit_spread(ResultField{"separation", "m", "Clear distance, daylight positive"}, r.separation, visit);
  visit(ResultField{"static_reaction", "N", "Reaction in the static state"}, r.static_reaction);
  visit(ResultField{"static_separation", "m", "Clear distance in the static state"}, r.static_separation);
  visit(ResultField{"contact_share", "1", "Share of the time in contact"}, r.contact_share);
  visit(ResultField{"impact_count", "1", "Number of impacts"}, r.impact_count);
}

template <class Row, class Visit>
void visit_dynamic_support(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the roller box"}, r.name);
  visit(ResultField{"stinger", "1", "1 on the stinger, 0 on the ramp"}, r.stinger);
  visit(ResultField{"s", "m", "Arc length of the pipe at the middle of the box in the static state"}, r.s);
  visit_spread(ResultField{"reaction", "N", "Resultant of all rollers on the pipe, magnitude"}, r.reaction, visit);
  visit(ResultField{"reaction_p50", "N", "Reaction not passed for 50 % of the time"}, r.reaction_over_time.p50);
  visit(ResultField{"reaction_p90", "N", "Reaction not passed for 90 % of the time"}, r.reaction_over_time.p90);
  visit(ResultField{"reaction_p99", "N", "Reaction not passed for 99 % of the time"}, r.reaction_over_time.p99);
  visit_spread(ResultField{"vertical", "N", "Vertical part of the resultant", kWorldFrame}, r.vertical, visit);
  visit_spread(ResultField{"longitudinal", "N", "Part of the resultant along the box axis, astern positive", kBoxFrame},
               r.longitudinal, visit);
  visit_spread(ResultField{"lateral", "N", "Part of the resultant across, port positive", kBoxFrame}, r.lateral, visit);
  visit_contact_over_time(r, visit);
}

template <class Row, class Visit>
void visit_dynamic_roller(Row& r, Visit& visit) {
  visit(ResultField{"roller", "1", "Number of the roller through all boxes, from 0"}, r.roller);
  visit(ResultField{"box", "1", "Number of its box, from 0"}, r.box);
  visit(ResultField{"row", "1", "Number of its row within the box, from 0"}, r.row);
  visit(ResultField{"position", "1", "Place in the row: bottom, port or starboard"}, r.position);
  visit_spread(ResultField{"reaction", "N", "Normal contact force on the pipe"}, r.reaction, visit);
  visit_contact_over_time(r, visit);
  visit(ResultField{"largest_approach_velocity", "m/s", "Largest normal velocity at first touch"},
        r.largest_approach_velocity);
  visit(ResultField{"largest_impact_force", "N", "Largest force of an impact"}, r.largest_impact_force);
  visit(ResultField{"largest_impulse", "N s", "Largest impulse of an impact"}, r.largest_impulse);
  visit(ResultField{"dent_depth", "m", "Dent of bare steel under the largest force"}, r.dent_depth);
  visit(ResultField{"line_load", "N/m", "Largest force over the length of the coating under the roller"}, r.line_load);
}

template <class Row, class Visit>
void visit_impact(Row& r, Visit& visit) {
  visit(ResultField{"time", "s", "Of first touch"}, r.time);
  visit(ResultField{"roller", "1", "Number of the roller through all boxes, from 0"}, r.roller);
  visit(ResultField{"approach_velocity", "m/s", "Normal velocity at first touch"}, r.approach_velocity);
  visit(ResultField{"peak_force", "N", "Largest normal force"}, r.peak_force);
  visit(ResultField{"duration", "s", "To separation, or to where the force has passed its peak and the pipe stays"},
        r.duration);
  visit(ResultField{"impulse", "N s", "Integral of the normal force over the duration"}, r.impulse);
  visit(ResultField{"dent_depth", "m", "Dent of bare steel under the peak force"}, r.dent_depth);
  visit(ResultField{"line_load", "N/m", "Peak force over the length of the coating under the roller"}, r.line_load);
}

template <class Row, class Visit>
void visit_estimate(Row& r, Visit& visit) {
  const char* varies = "see column units";
  visit(ResultField{"name", "1", "Name of the history"}, r.name);
  visit(ResultField{"units", "1", "Units of its values"}, r.units);
  visit(ResultField{"smallest", "1", "1: of the smallest value, the columns then are of that"}, r.smallest);
  visit(ResultField{"peaks", "1", "Number of peaks between mean up-crossings, from t = 0"}, r.peaks);
  visit(ResultField{"observed", varies, "Largest (smallest) value of the run"}, r.observed);
  visit(ResultField{"weibull", varies, "Most probable largest (smallest) value in three hours by a Weibull fit"},
        r.weibull);
  visit(ResultField{"weibull_low", varies, "Lower bound of it at 95 % confidence"}, r.weibull_low);
  visit(ResultField{"weibull_high", varies, "Upper bound of it at 95 % confidence"}, r.weibull_high);
  visit(ResultField{"gumbel", varies, "Most probable largest (smallest) value in three hours by a Gumbel fit"},
        r.gumbel);
  visit(ResultField{"gumbel_low", varies, "Lower bound of it at 95 % confidence"}, r.gumbel_low);
  visit(ResultField{"gumbel_high", varies, "Upper bound of it at 95 % confidence"}, r.gumbel_high);
  visit(ResultField{"enough", "1", "0: too few peaks to fit, the estimates are the observed value"}, r.enough);
}

/// Columns per station: visit(field, numbers) and visit(field, places).
template <class Results, class Visit>
void visit_dynamic_stations(Results& r, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed arc length from the anchor"}, r.station_s);
  visit(ResultField{"static", "m", "Place in the static state", kWorldFrame}, r.static_place);
  visit(ResultField{"static_tension", "N", "Effective tension in the static state"}, r.static_tension);
  visit(ResultField{"static_moment", "N m", "Bending moment in the static state"}, r.static_moment);
  visit(ResultField{"static_bending_stress", "Pa", "Bending stress in the static state"}, r.static_bending_stress);
  visit(ResultField{"static_von_mises", "Pa", "Largest von Mises stress of the section in the static state"},
        r.static_von_mises);
  visit(ResultField{"static_strain", "1", "Largest strain of the section in the static state"}, r.static_strain);
  visit_spread(ResultField{"effective_tension", "N", "Effective tension"}, r.effective_tension, visit);
  visit_spread(ResultField{"bending_moment", "N m", "Bending moment, magnitude"}, r.bending_moment, visit);
  visit_spread(ResultField{"bending_stress", "Pa", "Bending stress at the outer fibre of the steel"}, r.bending_stress,
               visit);
  visit_spread(ResultField{"von_mises", "Pa", "Largest von Mises stress over the section"}, r.von_mises, visit);
  visit_spread(ResultField{"strain", "1", "Largest longitudinal strain magnitude at the outer fibre"}, r.strain, visit);
  visit_spread(ResultField{"x", "m", "Place", kWorldFrame}, r.x, visit);
  visit_spread(ResultField{"y", "m", "Place", kWorldFrame}, r.y, visit);
  visit_spread(ResultField{"z", "m", "Place", kWorldFrame}, r.z, visit);
}

}  // namespace overbend
