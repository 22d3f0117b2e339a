/// Rows of a floating hull and its mooring lines over time, and of what is told of the hull; result_field.h has the
/// idea.
#pragma once

#include "results/fields/result_field.h"
#include "results/hull_results.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// A quantity with its slow and wave part. In summary.json one object: {min, max, mean, std, slow, wave, ...}.
template <class Motion, class Visit>
void visit_motion(const std::string& name, const char* units, const std::string& what, Motion& m, Visit& visit) {
  const auto part = [&](const char* suffix, const char* of, auto& member, auto visit_member) {
    const std::string key = name + "/" + suffix, meaning = what + of;
    visit_member(ResultField{name + "_" + suffix, units, meaning}.summary(key), member);
  };
  const auto spread = [&](const ResultField& field, auto& member) { visit_spread(field, member, visit); };
  const auto value = [&](const ResultField& field, auto& member) { visit(field, member); };
  const std::string whole = name + "/*";
  spread(ResultField{name, units, what}.summary(whole), m.whole);
  part("slow", ", slow part", m.slow, spread);
  part("wave", ", wave part", m.wave, spread);
  part("most_probable_min", ", most probable least in three hours", m.most_probable_min, value);
  part("most_probable_max", ", most probable largest in three hours", m.most_probable_max, value);
  units = "1";
  part("slow_cycles", ", cycles of the slow part in the run", m.slow_cycles, value);
  part("wave_cycles", ", cycles of the wave part in the run", m.wave_cycles, value);
  part("slow_std_error", ", standard error of the slow part's deviation as a share of it", m.slow_std_error, value);
}

template <class Row, class Visit>
void visit_vessel_dynamics(Row& r, Visit& visit) {
  visit_motion("surge", "m", "Shift of midship forward from the drawn place", r.surge, visit);
  visit_motion("sway", "m", "Shift of midship to port from the drawn place", r.sway, visit);
  visit_motion("heave", "m", "Shift of midship upwards from the drawn place", r.heave, visit);
  visit_motion("roll", "rad", "Starboard down, from as drawn", r.roll, visit);
  visit_motion("pitch", "rad", "Bow down, from as drawn", r.pitch, visit);
  visit_motion("yaw", "rad", "Bow to port, from as drawn", r.yaw, visit);
  visit_motion("along", "m", "Shift ahead from the place at the start", r.along, visit);
  visit_motion("across", "m", "Shift to port from the place at the start", r.across, visit);
  visit_motion("offset", "m", "Horizontal distance from the place at the start", r.offset, visit);
  visit(ResultField{"covariance", "m^2", "Covariance of the shifts along and across"}.summary(), r.covariance);
  visit(ResultField{"start_surge", "m", "Surge at the start of the run"}.summary("start/surge"), r.start_surge);
  visit(ResultField{"start_sway", "m", "Sway at the start of the run"}.summary("start/sway"), r.start_sway);
  visit(ResultField{"start_yaw", "rad", "Yaw at the start of the run"}.summary("start/yaw"), r.start_yaw);
  visit(ResultField{"cut_off", "s", "Longer periods are slow, shorter ones waves"}.summary("cut_off_period"),
        r.cut_off);
  visit(ResultField{"confidence", "1", "How many slow cycles the run holds"}.summary(), r.confidence);
}

template <class Row, class Visit>
void visit_thrust_dynamics(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "surge, sway or yaw: ahead, to port, bow to port of the slow heading"}.summary(),
        r.name);
  visit_spread(ResultField{"given", "N", "Thrust; of yaw a moment, N m"}.summary(), r.given, visit);
  visit(ResultField{"largest_asked", "N", "Largest magnitude that is asked for; of yaw a moment, N m"}.summary(),
        r.largest_asked);
  visit(ResultField{"thrust_limit", "N", "What there is; of yaw a moment, N m"}.summary(), r.limit);
  visit(ResultField{"time_at_limit", "s", "Time in which more is asked for than there is"}.summary(), r.time_at_limit);
}

/// All but points and events.
template <class Row, class Visit>
void visit_mooring_dynamics(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the line"}.summary(), r.name);
  visit_motion("fairlead_tension", "N", "Tension at the fairlead", r.fairlead_tension, visit);
  visit_motion("anchor_tension", "N", "Tension at the anchor", r.anchor_tension, visit);
  visit(ResultField{"start_fairlead_tension", "N", "Tension at the fairlead at the start of the run"}.summary(),
        r.start_fairlead_tension);
  visit(
      ResultField{"intact_fairlead_tension", "N", "Largest tension at the fairlead while no line has parted"}.summary(),
      r.intact_fairlead_tension);
  visit(ResultField{"intact_anchor_tension", "N", "Largest tension at the anchor while no line has parted"}.summary(),
        r.intact_anchor_tension);
  visit(ResultField{"utilisation", "1", "Largest tension over the least breaking load"}.summary(), r.utilisation);
  visit(ResultField{"most_probable_utilisation", "1",
                    "Most probable largest tension in three hours over the least breaking load"}
            .summary(),
        r.most_probable_utilisation);
  visit(ResultField{"anchor_utilisation", "1", "Largest tension at the anchor over its holding power"}.summary(),
        r.anchor_utilisation);
  visit(ResultField{"least_on_bed", "m", "Least unstressed length on the bed"}.summary(), r.least_on_bed);
  visit(ResultField{"largest_uplift", "N", "Largest vertical pull on the anchor"}.summary(), r.largest_uplift);
  visit(ResultField{"time_slack", "s", "Time with less than a tenth of the tension at the start"}.summary(),
        r.time_slack);
  visit(ResultField{"clearance", "m", "Least distance to the objects on the bed, of the snapshots"}.summary(),
        r.clearance);
  visit(ResultField{"nearest_object", "1", "The object it is of; empty without objects"}.summary(), r.nearest_object);
  visit_spread(ResultField{"length", "m", "Unstressed length from the anchor to the fairlead"}.summary(), r.length,
               visit);
  visit(ResultField{"parted_at", "s", "When it parted"}.summary(), r.parted_at);
  visit(ResultField{"anchor_slip", "m", "How far the anchor slipped in all"}.summary(), r.anchor_slip);
  visit(ResultField{"brake_rendered", "m", "Length that the winch's brake let out in all"}.summary(), r.brake_rendered);
}

template <class Row, class Visit>
void visit_mooring_event(Row& r, Visit& visit) {
  visit(ResultField{"time", "s", "When"}.summary(), r.time);
  visit(ResultField{"what", "1", "What happened"}.summary(), r.what);
}

/// Single values of a hull.
template <class Row, class Visit>
void visit_hull(Row& r, Visit& visit) {
  visit(ResultField{"states", "1", "Numbers that the water's memory consists of"}.summary(), r.states);
  visit(ResultField{"below_table", "1", "Share of the sea's variance below the frequencies of the wave forces"}.summary(
            "variance_below_table"),
        r.below_table);
  visit(ResultField{"above_table", "1", "Share of the sea's variance above them"}.summary("variance_above_table"),
        r.above_table);
  visit(ResultField{"current_least", "N", "Sideways current force with a drag coefficient of 0.44"}.summary(
            "current_range/least"),
        r.current_least);
  visit(ResultField{"current_most", "N", "Sideways current force with a drag coefficient of 1.2"}.summary(
            "current_range/most"),
        r.current_most);
}

/// One of drift, current, wind.
template <class Row, class Visit>
void visit_steady_load(const std::string& name, const std::string& what, Row& r, Visit& visit) {
  const std::string surge = name + "/surge", sway = name + "/sway", yaw = name + "/yaw";
  const std::string forward = what + ", forward", port = what + ", to port", turning = what + ", bow to port";
  visit(ResultField{name + "_surge", "N", forward}.summary(surge), r.surge);
  visit(ResultField{name + "_sway", "N", port}.summary(sway), r.sway);
  visit(ResultField{name + "_yaw", "N m", turning}.summary(yaw), r.yaw);
}

template <class Row, class Visit>
void visit_steady_loads(Row& r, Visit& visit) {
  visit_steady_load("drift", "Mean drift force of the waves", r.drift, visit);
  visit_steady_load("current", "Force of the current on the hull at rest", r.current, visit);
  visit_steady_load("wind", "Force of the wind on the hull at rest", r.wind, visit);
}

/// A pair of modes of the radiation.
template <class Row, class Visit>
void visit_radiation_entry(Row& r, Visit& visit) {
  visit(ResultField{"first", "1", "Mode of the force"}.summary(), r.first);
  visit(ResultField{"second", "1", "Mode of the motion"}.summary(), r.second);
  visit(ResultField{"damping_error", "1", "Largest error of the damping, share of its largest value"}.summary(),
        r.damping_error);
  visit(ResultField{"added_mass_error", "1", "Largest error of the added mass, share of its largest value"}.summary(),
        r.mass_error);
  visit(ResultField{"added_mass_file", "1", "Added mass at infinite frequency of the file, SI"}.summary(),
        r.added_mass_file);
  visit(ResultField{"added_mass_used", "1", "The one in use, which belongs to the memory, SI"}.summary(),
        r.added_mass_used);
  visit(ResultField{"tail_exponent", "1", "Power of the frequency by which the damping falls beyond the file's"}
            .summary(),
        r.tail_exponent);
}

template <class Row, class Visit>
void visit_radiation_group(Row& r, Visit& visit) {
  visit(ResultField{"modes", "1", "Modes that are fitted together"}.summary(), r.modes);
  visit(ResultField{"method", "1", "State space or convolution"}.summary(), r.method);
  visit(ResultField{"order", "1", "Number of poles"}.summary(), r.order);
  visit(ResultField{"least_damping", "1", "Smallest eigenvalue of the fitted damping, share of the largest"}.summary(),
        r.least_damping);
  visit(ResultField{"least_damping_omega", "rad/s", "Frequency at which it is"}.summary(), r.least_damping_omega);
  visit(ResultField{"added_damping", "1", "Constant damping added for passivity, share of the largest"}.summary(),
        r.added_damping);
}

/// Damping of a slow motion.
template <class Row, class Visit>
void visit_mode_damping(Row& r, Visit& visit) {
  visit(ResultField{"mode", "1", "Motion"}.summary(), r.mode);
  visit(ResultField{"period", "s", "Natural period of the motion alone"}.summary(), r.period);
  visit(ResultField{"critical", "1", "Critical damping, SI"}.summary(), r.critical);
  visit(ResultField{"total", "1", "Damping ratio"}.summary(), r.total);
  visit(ResultField{"radiation", "1", "Part of radiated waves"}.summary(), r.radiation);
  visit(ResultField{"radiation_file", "1", "The same by the damping of the file"}.summary(), r.radiation_file);
  visit(ResultField{"drift", "1", "Part of the waves' drift"}.summary(), r.drift);
  visit(ResultField{"current", "1", "Part of the current"}.summary(), r.current);
  visit(ResultField{"viscous", "1", "Part of the damping given"}.summary(), r.viscous);
  visit(ResultField{"station_keeping", "1", "Part of dynamic positioning"}.summary(), r.station_keeping);
}

}  // namespace overbend
