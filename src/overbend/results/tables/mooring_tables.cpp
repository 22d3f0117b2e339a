#include "results/tables/mooring_tables.h"

#include <algorithm>
#include <array>

#include "base/ranges.h"
#include "results/fields/mooring_fields.h"
#include "results/tables/field_table.h"

namespace overbend {
namespace {

const char* remark(const MooringLineResult& line) {
  return line.parted ? "parted" : line.slack ? "slack" : line.anchor_uplift > 0.0 ? "lifts its anchor" : "";
}

bool is_over(const std::optional<double>& use, const std::optional<double>& anchor_use) {
  return use.value_or(0.0) > 1.0 || anchor_use.value_or(0.0) > 1.0;
}

/// Replaces numbers without meaning by dashes, from a column on; empty cells stay empty.
void dash_numbers(TableRow& row, std::size_t from) {
  for (std::size_t i = from; i < row.cells.size(); ++i) {
    if (std::holds_alternative<double>(row.cells[i])) row.cells[i] = "-";
  }
}

/// Table of quantities with low-frequency and wave-frequency motion, each in its own unit.
Table motion_table(const std::string& title) {
  Table table{title, {TableColumn("Motion"), TableColumn("Unit")}, "dense summary"};
  table.columns[0].key = "name";
  table.columns[1].key = "unit";
  constexpr std::array<std::pair<const char*, const char*>, 11> kStatistics = {{{"min", "min"},
                                                                                {"max", "max"},
                                                                                {"mean", "mean"},
                                                                                {"std", "std"},
                                                                                {"min", "slow_min"},
                                                                                {"max", "slow_max"},
                                                                                {"std", "slow_std"},
                                                                                {"max", "wave_max"},
                                                                                {"std", "wave_std"},
                                                                                {"least", "most_probable_min"},
                                                                                {"largest", "most_probable_max"}}};
  for (const auto& [heading, key] : kStatistics) {
    table.column(TableColumn::texts(heading));
    table.columns.back().key = key;
  }
  return table.groups(
      {{"", 2}, {"Whole", 4}, {"Low-frequency part", 3}, {"Wave-frequency part", 2}, {"Most probable in 3 h", 2}});
}

void add_motion(Table& table, const std::string& name, std::string_view si, int digits,
                const MotionStatistics& motion) {
  const SummaryStatistics &total = motion.whole, &slow = motion.slow, &wave = motion.wave;
  std::vector<TableCell> cells = {name, shown_name(si)};
  for (const std::optional<double>& value : std::initializer_list<std::optional<double>>{
           total.min, total.max, total.mean, total.std, slow.min, slow.max, slow.std, wave.max, wave.std,
           motion.most_probable_min, motion.most_probable_max}) {
    cells.push_back(value ? shown_number(*value, si, digits) : "-");
  }
  table.row(cells);
}

/// A column with a key.
TableColumn keyed(const char* key, TableColumn column) {
  column.key = key;
  return column;
}

}  // namespace

const char* course(const DynamicResults& results) {
  return results.station_s.empty() ? "hull" : "route";
}

Table moorings_at_rest(const std::vector<MooringLineResult>& lines) {
  Table table = field_table("Mooring lines at rest", lines, TableAudience::people, [](const auto& line, auto& visit) {
    visit_mooring_line(line, visit);
    visit_mooring_use(line, visit);
  });
  table.look = "dense summary";
  table.column(keyed("nearest_object", TableColumn("to"))).column(keyed("remark", TableColumn("")));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const MooringLineResult& line = lines[i];
    TableRow& row = table.rows[i];
    if (line.parted) dash_numbers(row, 2);
    row.cells.emplace_back(line.nearest_object);
    row.cells.emplace_back(remark(line));
    row.mark = is_over(line.utilisation, line.anchor_utilisation) ? RowMark::over
               : line.parted || line.slack                        ? RowMark::soft
                                                                  : RowMark::none;
  }
  return table.drop_empty_columns();
}

Table vessel_motions(const VesselDynamics& v, const std::string& course) {
  Table table = motion_table("Motion of the vessel: low-frequency and wave-frequency parts");
  add_motion(table, "Surge, forward", "m", 3, v.surge);
  add_motion(table, "Sway, to port", "m", 3, v.sway);
  add_motion(table, "Heave, up", "m", 3, v.heave);
  add_motion(table, "Roll, starboard down", "rad", 3, v.roll);
  add_motion(table, "Pitch, bow down", "rad", 3, v.pitch);
  add_motion(table, "Yaw, bow to port", "rad", 3, v.yaw);
  add_motion(table, "Along the " + course + ", ahead", "m", 3, v.along);
  add_motion(table, "Across the " + course + ", to port", "m", 3, v.across);
  add_motion(table, "Horizontal offset", "m", 3, v.offset);
  return table;
}

Table fairlead_tensions(const std::vector<MooringLineDynamics>& lines) {
  Table table = motion_table("Tension at the fairleads: low-frequency and wave-frequency parts");
  table.columns[0].title = "Line";
  for (const MooringLineDynamics& line : lines) add_motion(table, line.name, "N", 1, line.fairlead_tension);
  return table;
}

Table moorings_over_time(const std::vector<MooringLineDynamics>& lines) {
  Table table{
      "Mooring lines over time",
      {keyed("name", TableColumn("Line")), keyed("start_fairlead_tension", {"start", "N", 1}),
       keyed("fairlead_tension_max", {"largest", "N", 1}), keyed("utilisation", {"utilisation", "", 3}),
       keyed("most_probable_utilisation", {"most probable", "", 3}), keyed("anchor_tension_max", {"largest", "N", 1}),
       keyed("anchor_utilisation", {"utilisation", "", 3}), keyed("largest_uplift", {"uplift", "N", 1}),
       keyed("least_on_bed", {"Min. on seabed", "m", 1}), keyed("time_slack", {"Time slack", "s", 1}),
       keyed("brake_rendered", {"Brake rendered", "m", 2}), keyed("anchor_slip", {"Anchor slip", "m", 2}),
       keyed("clearance", {"Clearance", "m", 1}), keyed("nearest_object", TableColumn("to"))},
      "dense summary"};
  table.groups({{"", 1}, {"Tension at the fairlead", 4}, {"Anchor", 3}});
  const bool slips = ranges::any_of(
      lines, [](const MooringLineDynamics& line) { return line.brake_rendered > 0.0 || line.anchor_slip > 0.0; });
  const auto slip = [&](double value) { return slips ? std::optional(value) : std::nullopt; };
  for (const MooringLineDynamics& l : lines) {
    table.row(
        {l.name, l.start_fairlead_tension, l.fairlead_tension.whole.max, l.utilisation, l.most_probable_utilisation,
         l.anchor_tension.whole.max, l.anchor_utilisation, l.max_uplift, l.min_on_seabed, l.time_slack,
         slip(l.brake_rendered), slip(l.anchor_slip), l.clearance, l.nearest_object},
        is_over(l.utilisation, l.anchor_utilisation) ? RowMark::over : RowMark::none);
  }
  return table.drop_empty_columns();
}

Table thrust_over_time(const std::vector<ThrustDynamics>& all) {
  Table table{"Dynamic positioning over time", {keyed("name", TableColumn("Thrust"))}, "dense summary"};
  constexpr std::array<std::pair<const char*, const char*>, 6> kValues = {{{"Mean", "mean"},
                                                                           {"Std", "std"},
                                                                           {"Min", "min"},
                                                                           {"Max", "max"},
                                                                           {"Max. demand", "largest_asked"},
                                                                           {"Limit", "limit"}}};
  for (const auto& [heading, key] : kValues) table.column(keyed(key, TableColumn::texts(heading)));
  table.column(keyed("time_at_limit", {"At the limit", "s", 1})).column(keyed("unit", TableColumn("Unit")));
  constexpr std::array<const char*, 3> kNames = {"Thrust ahead", "Thrust to port", "Moment, bow to port"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const ThrustDynamics& thrust = all[i];
    const char* const si = i == 2 ? "N m" : "N";
    const auto text = [&](double value) { return shown_number(value, si, i == 2 ? 0 : 1); };
    table.row(
        {kNames.at(i), text(thrust.given.mean), text(thrust.given.std), text(thrust.given.min), text(thrust.given.max),
         text(thrust.max_demand), thrust.limit ? text(*thrust.limit) : "none", thrust.time_at_limit, shown_name(si)},
        thrust.time_at_limit > 0.0 ? RowMark::over : RowMark::none);
  }
  return table;
}

Table mooring_events(const std::vector<MooringLineDynamics>& lines) {
  Table table{"Events of the mooring lines", {{"Time", "s", 1}, TableColumn("Line"), TableColumn("Event")}};
  for (const MooringLineDynamics& line : lines) {
    for (const MooringEvent& event : line.events) table.row({event.time, line.name, event.what});
  }
  ranges::stable_sort(table.rows, {}, [](const TableRow& row) { return std::get<double>(row.cells[0]); });
  return table;
}

}  // namespace overbend
