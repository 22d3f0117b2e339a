/// Fields of the tables of checks; see result_field.h. Their order is that of checks.csv.
#pragma once

#include "results/dynamic_results.h"
#include "results/fields/result_field.h"

namespace overbend {

/// Identity and outcome of a check.
template <class Row, class Visit>
void visit_check_head(Row& r, Visit& visit) {
  visit(ResultField{"id", "1", "Name of the check for scripts"}.summary().page(), r.id);
  visit(ResultField{"name", "1", "Name of the check"}.csv("check").summary().page(), r.name);
  visit(ResultField{"code", "1", "Code with its edition"}.csv("code").summary().page(), r.code);
  visit(ResultField{"clause", "1", "Clause of the code"}.csv("clause").summary().page(), r.clause);
  visit(
      ResultField{"region", "1", "Part of the line: line (all of it), tower, overbend, stinger tip, sagbend or seabed"}
          .csv("region")
          .summary()
          .page(),
      r.region);
  visit(ResultField{"status", "1", "passed, exceeded, outside validity or not done"}.csv("status").summary().page(),
        r.status);
  visit(ResultField{"governing", "1", "1 if governing, 0 if for information"}.csv("governing").summary().page(),
        r.governing);
}

/// Numbers of a completed check.
template <class Row, class Visit>
void visit_check_numbers(Row& r, Visit& visit) {
  visit(ResultField{"utilisation", "1", "Utilisation; 1 is the full capacity"}.csv("utilisation").summary().page(),
        r.utilisation);
  visit(ResultField{"reserve", "1", "Factor on the load effects that brings the utilisation to 1, at most 999"}
            .csv("reserve factor")
            .summary()
            .page(),
        r.reserve);
  visit(ResultField{"quantity", "1", "Quantity of demand and capacity"}.csv("quantity").summary().page(), r.quantity);
  visit(ResultField{"demand", kVaries, "Demand"}.csv("demand").summary(), r.demand);
  visit(ResultField{"capacity", kVaries, "Capacity in the presence of the other loads at the station"}
            .csv("capacity")
            .summary()
            .page(),
        r.capacity);
  visit(ResultField{"units", "1", "Units of demand and capacity"}.csv("units").summary().page(), r.units);
  visit(ResultField{"s", "m", "Arc length from the anchor at the maximum utilisation"}.csv("s").summary("at/s"), r.s);
  visit(ResultField{"from_top", "m", "Distance along the pipe from the tensioner"}
            .csv("from tensioner")
            .summary("at/from_top")
            .page("at/from_top"),
        r.from_top);
  visit(ResultField{"position", "m", "Position in the static state", kWorldFrame}.csv(kComponents).summary("at/"),
        r.p_W);
}

template <class Row, class Visit>
void visit_check(Row& r, Visit& visit) {
  visit_check_head(r, visit);
  visit_check_numbers(r, visit);
  visit(ResultField{"in_time", "1", "1 for an instant of the run, 0 for the static state or without an instant"},
        r.in_time);
  visit(ResultField{"time", "s", "Time, if in_time is 1"}.csv("time"), r.time);
  visit(ResultField{"remark", "1", "Remark"}.csv("remark"), r.remark);
  visit(ResultField{"line", "1",
                    "Stand-alone line that is checked; s is measured from its first end. Empty for "
                    "other checks"}
            .csv("line"),
        r.line);
}

template <class Row, class Visit>
void visit_check_input(Row& r, Visit& visit) {
  visit(ResultField{"symbol", "1", "Symbol in the code's formula"}.summary(), r.symbol);
  visit(ResultField{"meaning", "1", "Meaning"}.summary(), r.meaning);
  visit(ResultField{"value", kVaries, "Its value"}.summary(), r.value);
  visit(ResultField{"units", "1", "Units of the value"}.summary(), r.units);
}

template <class Line, class Visit>
void visit_sheet_line(Line& r, Visit& visit) {
  visit(ResultField{"symbol", "1", "Symbol of the quantity in the formulas of the sheet"}.csv("symbol").summary(),
        r.symbol);
  visit(ResultField{"meaning", "1", "Meaning"}.csv("meaning").summary(), r.meaning);
  visit(ResultField{"formula", "1", "Formula in the symbols of the preceding lines; empty for an input"}
            .csv("formula")
            .summary(),
        r.formula);
  visit(ResultField{"value", kVaries, "Value used by the check"}.csv("value").summary(), r.value);
  visit(ResultField{"units", "1", "Units of the value"}.csv("units").summary(), r.units);
  visit(ResultField{"origin", "1", "Clause of the code, or origin of an input"}.csv("origin").summary(), r.origin);
  visit(ResultField{"confirmation", "1",
                    "Public restatements of the formula that agree: two or more sources, one source, unconfirmed; not "
                    "needed for inputs and definitions"}
            .csv("confirmation")
            .summary(),
        r.confirmation);
  visit(ResultField{"sources", "1", "Public texts that the formula was compared with"}.csv("sources").summary(),
        r.sources);
}

/// Columns along the pipe: visit(field, numbers).
template <class Along, class Visit>
void visit_check_along(Along& a, Visit& visit) {
  visit(ResultField{"s", "m", "Unstressed arc length from the anchor"}, a.s);
  visit(ResultField{"load", "1", "Utilisation, DNV-ST-F101 load controlled"}, a.load);
  visit(ResultField{"strain", "1", "Utilisation, DNV-ST-F101 displacement controlled; 0 off the supports"}, a.strain);
  visit(ResultField{"stress", "1", "Equivalent stress divided by 0.87 f_y; 0 over the supports"}, a.stress);
  visit(ResultField{"laying", "1",
                    "Strain divided by the limit of the simplified laying criteria; 0 away from the supports"},
        a.laying);
  visit(ResultField{"api", "1", "Utilisation, API RP 1111 bending and external pressure"}, a.api);
  visit(ResultField{"governing", "1", "Maximum utilisation of the governing checks at the station"}.page("checks"),
        a.governing);
}

/// Columns of DesignPeaks; `before` is the prefix of each name.
template <class Peaks, class Visit>
void visit_design_peaks(Peaks& p, const std::string& before, Visit& visit) {
  visit(ResultField{before + "load", "1", "Largest utilisation, load controlled"}, p.load);
  visit(ResultField{before + "load_time", "s", "Time of that maximum"}, p.load_time);
  visit(ResultField{before + "moment", "N m", "Design bending moment at that instant"}, p.moment);
  visit(ResultField{before + "force", "N", "Design effective force at that instant"}, p.force);
  visit(ResultField{before + "load_pressure", "Pa", "External over internal pressure at that instant"},
        p.load_pressure);
  visit(ResultField{before + "share", "1",
                    "Reduction factor of the plastic moment due to the roller force at that instant"},
        p.share);
  visit(ResultField{before + "strain", "1", "Largest utilisation, displacement controlled; 0 off the supports"},
        p.strain);
  visit(ResultField{before + "strain_time", "s", "Time of that maximum"}, p.strain_time);
  visit(ResultField{before + "design_strain", "1", "Design strain at that instant"}, p.design_strain);
  visit(ResultField{before + "strain_pressure", "Pa", "External over internal pressure at that instant"},
        p.strain_pressure);
}

/// Design values per station of a run: visit(field, numbers).
template <class Design, class Visit>
void visit_station_design(Design& d, Visit& visit) {
  visit_design_peaks(d, "", visit);
  visit(ResultField{"largest_force", "N", "Largest magnitude of the design effective force"}, d.max_force);
  visit(ResultField{"von_mises_time", "s", "Time of the maximum von Mises stress"}, d.von_mises_time);
  visit(ResultField{"fibre_strain_time", "s", "Time of the maximum strain"}, d.fibre_strain_time);
  visit(ResultField{"tension_time", "s", "Time of the maximum effective tension"}, d.tension_time);
  visit_design_peaks(d.of_class[0], "class_low_", visit);
  visit_design_peaks(d.of_class[1], "class_medium_", visit);
  visit_design_peaks(d.of_class[2], "class_high_", visit);
}

}  // namespace overbend
