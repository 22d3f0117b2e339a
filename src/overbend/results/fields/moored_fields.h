/// Fields of a floating hull and its mooring lines over time, and of the diagnostics of the hull; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/hull_results.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// A quantity with its low-frequency and wave-frequency parts. In summary.json one object: {min, max, mean, std, slow,
/// wave, ...}.
template <class Motion, class Visit>
void visit_motion(const std::string& name, const char* units, const std::string& what, Motion& m, Visit& visit) {
  const auto part = [&](const char* suffix, const char* of, auto& member, auto visit_member) {
    const std::string key = name + "/" + suffix, meaning = what + of;
    visit_member(ResultField{name + "_" + suffix, units, meaning}.summary(key), member);
  };
  const auto spread = [&](const ResultField& field, auto& member) { visit_spread(field, member, visit); };
  const auto value = [&](const ResultField& field, auto& member) { visit(field, member); };
  const std::string pattern = name + "/*";
  spread(ResultField{name, units, what}.summary(pattern), m.whole);
  part("slow", ", low-frequency part", m.slow, spread);
  part("wave", ", wave-frequency part", m.wave, spread);
  part("most_probable_min", ", most probable minimum in three hours", m.most_probable_min, value);
  part("most_probable_max", ", most probable maximum in three hours", m.most_probable_max, value);
  units = "1";
  part("slow_cycles", ", cycles of the low-frequency part in the run", m.slow_cycles, value);
  part("wave_cycles", ", cycles of the wave-frequency part in the run", m.wave_cycles, value);
  part("slow_std_error", ", relative standard error of the low-frequency standard deviation", m.slow_std_error, value);
}

template <class Row, class Visit>
void visit_vessel_dynamics(Row& r, Visit& visit) {
  visit_motion("surge", "m", "Shift of midship forward from the nominal position", r.surge, visit);
  visit_motion("sway", "m", "Shift of midship to port from the nominal position", r.sway, visit);
  visit_motion("heave", "m", "Shift of midship upwards from the nominal position", r.heave, visit);
  visit_motion("roll", "rad", "Starboard down, from the nominal pose", r.roll, visit);
  visit_motion("pitch", "rad", "Bow down, from the nominal pose", r.pitch, visit);
  visit_motion("yaw", "rad", "Bow to port, from the nominal pose", r.yaw, visit);
  visit_motion("along", "m", "Shift ahead from the position at the start", r.along, visit);
  visit_motion("across", "m", "Shift to port from the position at the start", r.across, visit);
  visit_motion("offset", "m", "Horizontal distance from the position at the start", r.offset, visit);
  visit(ResultField{"covariance", "m^2", "Covariance of the shifts along and across"}.summary(), r.covariance);
  visit(ResultField{"start_surge", "m", "Surge at the start of the run"}.summary("start/surge"), r.start_surge);
  visit(ResultField{"start_sway", "m", "Sway at the start of the run"}.summary("start/sway"), r.start_sway);
  visit(ResultField{"start_yaw", "rad", "Yaw at the start of the run"}.summary("start/yaw"), r.start_yaw);
  visit(ResultField{"cut_off", "s", "Period that separates low-frequency and wave-frequency motion"}.summary(
            "cut_off_period"),
        r.cut_off);
  visit(ResultField{"confidence", "1", "Message on the number of low-frequency cycles in the run"}.summary(),
        r.confidence);
}

template <class Row, class Visit>
void visit_thrust_dynamics(Row& r, Visit& visit) {
  visit(ResultField{"name", "1",
                    "surge, sway or yaw: ahead, to port, bow to port, relative to the low-frequency "
                    "heading"}
            .summary(),
        r.name);
  visit_spread(ResultField{"given", "N", "Thrust; for yaw a moment, N m"}.summary(), r.given, visit);
  visit(ResultField{"largest_asked", "N", "Maximum magnitude of the demand; for yaw a moment, N m"}.summary(),
        r.max_demand);
  visit(ResultField{"thrust_limit", "N", "Limit; for yaw a moment, N m"}.summary(), r.limit);
  visit(ResultField{"time_at_limit", "s", "Time in which the demand exceeds the limit"}.summary(), r.time_at_limit);
}

/// All fields except points and events.
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
  visit(ResultField{"utilisation", "1", "Largest tension over the minimum breaking load"}.summary(), r.utilisation);
  visit(ResultField{"most_probable_utilisation", "1",
                    "Most probable largest tension in three hours over the minimum breaking load"}
            .summary(),
        r.most_probable_utilisation);
  visit(ResultField{"anchor_utilisation", "1", "Largest tension at the anchor over its holding power"}.summary(),
        r.anchor_utilisation);
  visit(ResultField{"least_on_bed", "m", "Minimum unstressed length on the seabed"}.summary(), r.min_on_seabed);
  visit(ResultField{"largest_uplift", "N", "Largest vertical pull on the anchor"}.summary(), r.max_uplift);
  visit(ResultField{"time_slack", "s", "Time with less than a tenth of the tension at the start"}.summary(),
        r.time_slack);
  visit(ResultField{"clearance", "m", "Minimum distance to the objects on the seabed, from snapshots"}.summary(),
        r.clearance);
  visit(ResultField{"nearest_object", "1", "Name of that object; empty without objects"}.summary(), r.nearest_object);
  visit_spread(ResultField{"length", "m", "Unstressed length from the anchor to the fairlead"}.summary(), r.length,
               visit);
  visit(ResultField{"parted_at", "s", "Time of parting"}.summary(), r.parted_at);
  visit(ResultField{"anchor_slip", "m", "Total slip of the anchor"}.summary(), r.anchor_slip);
  visit(ResultField{"brake_rendered", "m", "Total length rendered by the winch's brake"}.summary(), r.brake_rendered);
}

template <class Row, class Visit>
void visit_mooring_event(Row& r, Visit& visit) {
  visit(ResultField{"time", "s", "When"}.summary(), r.time);
  visit(ResultField{"what", "1", "Type of the event"}.summary(), r.what);
}

/// Single values of a hull.
template <class Row, class Visit>
void visit_hull(Row& r, Visit& visit) {
  visit(ResultField{"states", "1", "Number of states of the radiation memory"}.summary(), r.states);
  visit(ResultField{"below_table", "1", "Share of the sea's variance below the frequencies of the wave forces"}.summary(
            "variance_below_table"),
        r.below_table);
  visit(ResultField{"above_table", "1", "Share of the sea's variance above the frequencies of the wave forces"}.summary(
            "variance_above_table"),
        r.above_table);
  visit(ResultField{"current_least", "N", "Lateral current force with a drag coefficient of 0.44"}.summary(
            "current_range/least"),
        r.min_current_force);
  visit(ResultField{"current_most", "N", "Lateral current force with a drag coefficient of 1.2"}.summary(
            "current_range/most"),
        r.max_current_force);
}

/// A steady load: drift, current or wind.
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
  visit_steady_load("drift", "Mean wave drift force", r.drift, visit);
  visit_steady_load("current", "Current force on the hull in equilibrium", r.current, visit);
  visit_steady_load("wind", "Wind force on the hull in equilibrium", r.wind, visit);
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
  visit(ResultField{"added_mass_used", "1",
                    "Added mass at infinite frequency in use, consistent with the "
                    "radiation memory, SI"}
            .summary(),
        r.added_mass_used);
  visit(
      ResultField{"tail_exponent", "1", "Exponent of the decay of the damping above the file's frequencies"}.summary(),
      r.tail_exponent);
}

template <class Row, class Visit>
void visit_radiation_group(Row& r, Visit& visit) {
  visit(ResultField{"modes", "1", "Modes fitted together"}.summary(), r.modes);
  visit(ResultField{"method", "1", "State space or convolution"}.summary(), r.method);
  visit(ResultField{"order", "1", "Number of poles"}.summary(), r.order);
  visit(ResultField{"least_damping", "1", "Smallest eigenvalue of the fitted damping, share of the largest"}.summary(),
        r.min_fitted_damping);
  visit(ResultField{"least_damping_omega", "rad/s", "Frequency of that eigenvalue"}.summary(),
        r.min_fitted_damping_omega);
  visit(ResultField{"added_damping", "1", "Constant damping added for passivity, share of the largest"}.summary(),
        r.added_damping);
}

/// Damping of a low-frequency motion.
template <class Row, class Visit>
void visit_mode_damping(Row& r, Visit& visit) {
  visit(ResultField{"mode", "1", "Motion"}.summary(), r.mode);
  visit(ResultField{"period", "s", "Natural period of the motion alone"}.summary(), r.period);
  visit(ResultField{"critical", "1", "Critical damping, SI"}.summary(), r.critical);
  visit(ResultField{"total", "1", "Damping ratio"}.summary(), r.total);
  visit(ResultField{"radiation", "1", "Contribution of radiated waves"}.summary(), r.radiation);
  visit(ResultField{"radiation_file", "1", "The same from the damping of the file"}.summary(), r.radiation_file);
  visit(ResultField{"drift", "1", "Contribution of the wave drift"}.summary(), r.drift);
  visit(ResultField{"current", "1", "Contribution of the current"}.summary(), r.current);
  visit(ResultField{"viscous", "1", "Contribution of the damping given in the model"}.summary(), r.viscous);
  visit(ResultField{"station_keeping", "1", "Contribution of dynamic positioning"}.summary(), r.station_keeping);
}

}  // namespace overbend
