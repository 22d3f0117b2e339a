#include <fmt/format.h>

#include <algorithm>

#include "base/ranges.h"
#include "report/dynamic/dynamic_sections.h"
#include "report/page/key_statistics.h"
#include "report/page/quantity.h"
#include "report/page/static_value.h"

namespace overbend {
namespace {

/// A ratio is meaningful for forces, moments, stresses and strains; not for lengths and angles.
bool has_ratio(const std::string& units) {
  return units == "N" || units == "N m" || units == "Pa" || units == "1";
}

/// The table of statistics: each quantity in its own unit.
class Statistics {
 public:
  Statistics(const StaticResults& statics, const DynamicResults& results) : statics_(statics), results_(results) {
    for (const char* column : {"Static", "Min", "Mean", "Max", "Std. dev."}) table_.column(TableColumn::texts(column));
    table_.column({"Max / static", "-", 2});
  }

  void add(const std::string& name, const std::string& units, const SummaryStatistics& spread,
           bool is_maximum = false) {
    const Quantity q = quantity(name, units);
    const std::optional<double> before = static_value(statics_, results_, name);
    table_.row({is_maximum ? q.name + ", maximum of the region" : q.name, q.unit, before ? q.text(*before) : "",
                q.text(spread.min), q.text(spread.mean), q.text(spread.max), q.text(spread.std),
                before && *before > 0.0 && has_ratio(units) ? TableCell(spread.max / *before) : TableCell()});
  }

  void add_region(const std::string& region, const DynamicRegion& r) {
    add(region + "_bending_moment", "N m", r.bending_moment.over_time, true);
    add(region + "_bending_stress", "Pa", r.bending_stress.over_time, true);
    add(region + "_von_mises", "Pa", r.von_mises.over_time, true);
    add(region + "_strain", "1", r.strain.over_time, true);
  }

  void add_history(const std::string& name) {
    for (const HistorySummary& history : results_.histories) {
      if (history.name == name) add(history.name, history.units, history.over_time);
    }
  }

  const Table& table() const { return table_; }

 private:
  const StaticResults& statics_;
  const DynamicResults& results_;
  Table table_{"Statistics over time", {TableColumn("Quantity"), TableColumn("Unit")}, "plain full"};
};

void add_pipe(Statistics& rows, const StaticResults& statics, const DynamicResults& r) {
  rows.add("top_tension", "N", r.top_tension);
  rows.add("bottom_tension", "N", r.bottom_tension);
  if (statics.overbend) {
    rows.add_region("overbend", r.overbend);
  }
  rows.add_region("sagbend", r.sagbend);
  rows.add("lay_back", "m", r.lay_back);
  rows.add("departure_angle", "rad", r.departure_angle);
  if (statics.stinger_tip_clearance) {
    rows.add("stinger_tip_clearance", "m", r.stinger_tip_clearance);
  }
  for (const StingerSectionDynamics& section : r.stinger) {
    const std::string of = "stinger/" + section.name + "/";
    rows.add(of + "angle", "rad", section.angle);
    rows.add(of + "hinge_force", "N", section.hinge_force);
    rows.add(of + "hinge_longitudinal", "N", section.hinge_longitudinal);
    rows.add(of + "hinge_vertical", "N", section.hinge_vertical);
    rows.add(of + "stop_moment", "N m", section.stop_moment);
    rows.add(of + "draught", "m", section.draught);
  }
}

Table statistics_table(const StaticResults& statics, const DynamicResults& r) {
  Statistics rows(statics, r);
  if (statics.has_pipe()) add_pipe(rows, statics, r);
  for (const char* name : {"elevation", "surge", "sway", "heave", "roll", "pitch", "yaw"}) {
    rows.add_history(name);
  }
  for (const HistorySummary& history : r.histories) {
    if (history.name.starts_with("line/")) rows.add(history.name, history.units, history.over_time);
  }
  return rows.table();
}

bool is_of_moorings(const ExtremeEstimate& extreme) {
  return extreme.name.starts_with("mooring/");
}

std::vector<TableCell> extreme_cells(const StaticResults& statics, const DynamicResults& r, const ExtremeEstimate& e) {
  const Quantity q = quantity(e.name, e.units);
  const std::optional<double> before = static_value(statics, r, e.name);
  const std::optional<SummaryStatistics> spread = key_statistics(r, e.name);
  const double observed = !spread ? e.observed : e.is_minimum ? spread->min : spread->max;
  std::vector<TableCell> cells = {e.is_minimum ? q.name + ", smallest" : q.name, q.unit, before ? q.text(*before) : "",
                                  q.text(observed), e.peaks};
  const auto put = [&](const std::optional<double>& value, const std::optional<double>& low,
                       const std::optional<double>& high) {
    cells.push_back(value ? q.text(*value) : "");
    cells.push_back(value ? q.text(*low) + " to " + q.text(*high) : "");
  };
  put(e.estimate, e.low, e.high);
  cells.push_back(e.method.empty() || e.quality == "good" ? e.method : e.method + ", " + e.quality);
  put(e.estimate ? e.gumbel : std::nullopt, e.gumbel_low, e.gumbel_high);
  return cells;
}

/// Reasons why estimates are uncertain, each once with its quantities.
Blocks extreme_remarks(const DynamicResults& r, bool of_moorings) {
  std::vector<std::pair<std::string, std::string>> reasons;
  for (const ExtremeEstimate& e : r.extremes) {
    if (is_of_moorings(e) != of_moorings || e.remark.empty()) continue;
    const std::string name = quantity(e.name, e.units).name + (e.is_minimum ? ", smallest" : "");
    const auto known = ranges::find(reasons, e.remark, &std::pair<std::string, std::string>::first);
    if (known == reasons.end()) {
      reasons.emplace_back(e.remark, name);
    } else {
      known->second += "; " + name;
    }
  }
  Blocks remarks;
  for (const auto& [remark, names] : reasons) remarks += block::remark(fmt::format("{}: {}.", names, remark));
  return remarks;
}

/// Extremes of the lay, or of the mooring lines, which are numerous and have long names. Empty without any.
Blocks extremes_table(const StaticResults& statics, const DynamicResults& r, bool of_moorings) {
  const TableColumn estimate = TableColumn::texts("estimate"), interval = TableColumn::texts("95 % interval");
  Table table{of_moorings ? "Most probable extremes of the mooring lines in three hours"
                          : "Most probable extremes in three hours",
              {TableColumn("Quantity"),
               TableColumn("Unit"),
               TableColumn::texts("Static"),
               TableColumn::texts("Observed"),
               {"Peaks", "", 0},
               estimate,
               interval,
               TableColumn("by"),
               estimate,
               interval},
              of_moorings ? "dense" : "plain full"};
  table.groups({{"", 5}, {"Most probable in three hours", 3}, {"Gumbel, to compare", 2}});
  for (const ExtremeEstimate& e : r.extremes) {
    if (is_of_moorings(e) == of_moorings) table.row(extreme_cells(statics, r, e));
  }
  return Blocks(table) + extreme_remarks(r, of_moorings);
}

Blocks extremes(const StaticResults& statics, const DynamicResults& r) {
  if (r.extremes.empty()) return {};
  return extremes_table(statics, r, false) + extremes_table(statics, r, true) +
         block::remark(
             "Interval: 95 % confidence. Peaks are the maxima between mean up-crossings after the build-up. If "
             "there are too few, or no distribution fits the largest, only the observed value is given. Observed: "
             "maximum of this run, whose duration may differ from three hours.");
}

}  // namespace

Blocks dynamic_statistics_section(const StaticResults& statics, const DynamicResults& results) {
  return block::section("statistics", "Statistics and extremes",
                        statistics_table(statics, results) + extremes(statics, results));
}

}  // namespace overbend
