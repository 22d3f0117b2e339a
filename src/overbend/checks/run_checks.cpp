#include "checks/run_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/constants.h"
#include "checks/calculation_sheet.h"
#include "checks/check_assumptions.h"
#include "checks/check_row.h"
#include "checks/check_rows.h"
#include "checks/line_stations.h"
#include "checks/mooring_rows.h"

namespace overbend {
namespace {

void append(std::vector<CheckRow>& rows, const std::vector<CheckRow>& more) {
  rows.insert(rows.end(), more.begin(), more.end());
}

/// The strain over the supports relative to criterion I and, in dynamic analysis, II; 0 for a grade not covered by the
/// criteria.
double laying_at(const CheckStations& all, const CheckStation& station) {
  const CheckSection& section = all.section_of(station);
  if (!section.laying) return 0.0;
  const double still = station.strain / section.laying->static_strain;
  const double moving = section.strain_factor * station.largest_strain.value / section.laying->combined_strain;
  return all.in_time ? std::max(still, moving) : still;
}

/// Utilisations at every station, and the largest of those that decide there.
CheckAlong utilisations_along(const CheckStations& all, const CheckSettings& settings) {
  CheckAlong along;
  const bool dnv = settings.codes != CheckCodes::api, api = settings.codes != CheckCodes::dnv;
  for (const CheckStation& station : all.stations) {
    const bool supported = station.region == CheckRegion::overbend, free = !supported || station.leaves;
    const CheckSection& section = all.section_of(station);
    const bool load_holds = load_formula_holds(section.load, station.largest_force);
    const double load = dnv && load_holds ? station.load.value : 0.0;
    const double strain = dnv && supported ? station.bend.value : 0.0;
    const double stress = dnv && free ? station.largest_von_mises.value / section.stress_limit : 0.0;
    const double laying = dnv && supported ? laying_at(all, station) : 0.0;
    const bool bending_holds = section.wall.slenderness() <= kApiMostSlender;
    const double bending = api && bending_holds ? api_bending_at(all, station, settings) : 0.0;
    along.s.push_back(station.s);
    along.load.push_back(load);
    along.strain.push_back(strain);
    along.stress.push_back(stress);
    along.laying.push_back(laying);
    along.api.push_back(bending);
    along.governing.push_back(std::max({strain, free ? std::max(load, stress) : 0.0, laying, bending}));
  }
  return along;
}

/// A value of a shorter run is not the one that the criterion asks for.
void say_duration(CheckRow& row, double duration) {
  if (!row.judged()) return;
  row.remark += fmt::format("{}from {:.3g} min of a run, not the maximum of three hours",
                            row.remark.empty() ? "" : "; ", duration / 60.0);
}

/// The stinger tip begins at the last box that carries, which differs between lays: its rows say which box that is.
void say_where_tip_begins(std::vector<CheckRow>& rows, const StaticResults& statics) {
  const SupportResult* last = nullptr;
  for (const SupportResult& box : statics.supports) {
    if (box.reaction > 0.0) last = &box;
  }
  if (last == nullptr) return;
  const bool more = last != &statics.supports.back();
  for (CheckRow& row : rows) {
    if (row.region != CheckRegion::tip || !row.judged()) continue;
    row.remark += fmt::format("{}from '{}', the last box that carries{}", row.remark.empty() ? "" : "; ", last->name,
                              more ? "; those behind it carry nothing" : "");
  }
}

/// Of the pipe by the codes; none without one.
std::vector<CheckRow> rows_of_pipe(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows;
  if (all.stations.empty()) return rows;
  if (settings.codes != CheckCodes::api) append(rows, dnv_rows(all, settings));
  append(rows, laying_rows(all, settings));
  if (settings.codes != CheckCodes::dnv) append(rows, api_rows(all, settings));
  return rows;
}

/// Of a line by itself, each row with its name.
std::vector<CheckRow> rows_of_line(const CheckStations& line, const Model& model, bool in_time) {
  std::vector<CheckRow> rows = rows_of_pipe(line, model.description.checks);
  if (in_time && line.stations.empty() && !line.sections.empty()) {
    static constexpr CheckTitle kPipe = {"line_pipe", "Pipe of a line", "DNV-ST-F101, API RP 1111", "", "", ""};
    outside(rows.emplace_back(row_of(kPipe, CheckRegion::line)), "the run did not keep bending moments of lines");
  }
  const auto remark = [](CheckRow& row, const char* text) {
    row.remark += (row.remark.empty() ? "" : "; ") + std::string(text);
  };
  for (CheckRow& row : rows) {
    row.line = line.line;
    if (in_time && row.judged()) remark(row, "of the run, moment and tension of each place not of one instant");
    if (row.id != "dnv_load_controlled" || !raises_factors_for_current(model.description)) continue;
    remark(row, "in a current: all load effects have the factor of environmental ones");
  }
  return rows;
}

/// Of the lines that are pipe; none without any.
std::vector<CheckStations> stations_of_lines(const Model& model, const StaticResults& statics,
                                             const DynamicResults* dynamics) {
  if (!statics.lift) return {};
  return dynamics == nullptr ? line_stations(model, *statics.lift)
                             : line_stations_in_time(model, statics, dynamics->lines);
}

/// Of every object that is there. `dynamics`: of a run from that rest, or null.
CheckTable table_of(const Model& model, const StaticResults& statics, const DynamicResults* dynamics,
                    const CheckStations& all) {
  const CheckSettings& settings = model.description.checks;
  CheckTable table;
  table.rows = rows_of_pipe(all, settings);
  say_where_tip_begins(table.rows, statics);
  const auto pipe_rows = static_cast<std::ptrdiff_t>(table.rows.size());
  append(table.rows, equipment_rows(model, statics, dynamics));
  if (statics.moorings) append(table.rows, mooring_rows(model.description, *statics.moorings, dynamics));
  const std::vector<CheckStations> lines = stations_of_lines(model, statics, dynamics);
  for (const CheckStations& line : lines) append(table.rows, rows_of_line(line, model, dynamics != nullptr));
  append(table.rows, line_rows(model.description, statics.lines, dynamics != nullptr ? &dynamics->lines : nullptr));
  if (dynamics != nullptr && dynamics->duration < kThreeHours) {
    for (auto row = table.rows.begin(); row != table.rows.end(); ++row) {
      if (row->in_time || row - table.rows.begin() >= pipe_rows) say_duration(*row, dynamics->duration);
    }
  }
  if (dynamics != nullptr) append(table.rows, fatigue_rows(model, *dynamics));
  for (CheckRow& row : table.rows) {
    if (row.judged() && row.sheet.empty()) row.sheet = ratio_sheet(row);
  }
  table.along = utilisations_along(all, settings);
  table.assumptions = check_assumptions(all, settings);
  for (const CheckStations& line : lines) {
    table.assumptions = merge(std::move(table.assumptions), check_assumptions(line, settings));
  }
  return table;
}

/// The table's assumptions are the last of the results'; checks that are not judged are findings.
template <class Results>
void put(CheckTable table, Results& results) {
  const Assumptions& before = results.checks.assumptions;
  Assumptions& all = results.assumptions;
  if (all.size() >= before.size() && std::equal(before.rbegin(), before.rend(), all.rbegin())) {
    all.resize(all.size() - before.size());
  }
  all.insert(all.end(), table.assumptions.begin(), table.assumptions.end());
  std::erase_if(results.findings, [](const Finding& finding) { return finding.code == FindingCode::check_not_judged; });
  overbend::append(results.findings, unjudged_checks(table));
  results.checks = std::move(table);
}

}  // namespace

CheckTable check_statics(const Model& model, const StaticResults& statics) {
  return table_of(model, statics, nullptr, static_stations(model, statics));
}

CheckTable check_dynamics(const Model& model, const StaticResults& statics, const DynamicResults& dynamics) {
  return table_of(model, statics, &dynamics, dynamic_stations(model, statics, dynamics));
}

void fill_checks(const Model& model, StaticResults& statics) {
  put(check_statics(model, statics), statics);
}

void fill_checks(const Model& model, const StaticResults& statics, DynamicResults& dynamics) {
  put(check_dynamics(model, statics, dynamics), dynamics);
}

}  // namespace overbend
