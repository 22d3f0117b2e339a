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
  const CheckSection& section = all.section_for(station);
  if (!section.laying) return 0.0;
  const double static_ratio = station.strain / section.laying->static_strain;
  const double moving = section.strain_factor * station.max_strain.value / section.laying->combined_strain;
  return all.in_time ? std::max(static_ratio, moving) : static_ratio;
}

/// Returns the utilisations at every station, and the maximum of the governing ones.
CheckAlong utilisations_along(const CheckStations& all, const CheckSettings& settings) {
  CheckAlong along;
  const bool dnv = settings.codes != CheckCodes::api, api = settings.codes != CheckCodes::dnv;
  for (const CheckStation& station : all.stations) {
    const bool supported = station.region == CheckRegion::overbend, free = !supported || station.leaves;
    const CheckSection& section = all.section_for(station);
    const bool load_holds = load_formula_holds(section.load, station.max_force);
    const double load = dnv && load_holds ? station.load.value : 0.0;
    const double strain = dnv && supported ? station.bend.value : 0.0;
    const double stress = dnv && free ? station.max_von_mises.value / section.stress_limit : 0.0;
    const double laying = dnv && supported ? laying_at(all, station) : 0.0;
    const bool bending_holds = section.wall.slenderness() <= kMaxApiSlenderness;
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

/// Adds a remark if the run is shorter than the reference time of the criterion.
void add_duration_remark(CheckRow& row, double duration) {
  if (!row.judged()) return;
  row.remark += fmt::format("{}from {:.3g} min of a run, not the maximum of three hours",
                            row.remark.empty() ? "" : "; ", duration / 60.0);
}

/// The stinger tip begins at the last loaded box, which differs between cases: its rows name that box.
void add_tip_remark(std::vector<CheckRow>& rows, const StaticResults& statics) {
  const SupportResult* last = nullptr;
  for (const SupportResult& box : statics.supports) {
    if (box.reaction > 0.0) last = &box;
  }
  if (last == nullptr) return;
  const bool more = last != &statics.supports.back();
  for (CheckRow& row : rows) {
    if (row.region != CheckRegion::tip || !row.judged()) continue;
    row.remark += fmt::format("{}from '{}', the last loaded box{}", row.remark.empty() ? "" : "; ", last->name,
                              more ? "; the boxes behind it carry no load" : "");
  }
}

/// Returns the code checks of the pipe; empty without one.
std::vector<CheckRow> make_pipe_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows;
  if (all.stations.empty()) return rows;
  if (settings.codes != CheckCodes::api) append(rows, dnv_rows(all, settings));
  append(rows, laying_rows(all, settings));
  if (settings.codes != CheckCodes::dnv) append(rows, api_rows(all, settings));
  return rows;
}

/// Returns the rows of a standalone line, each with its name.
std::vector<CheckRow> make_line_rows(const CheckStations& line, const Model& model, bool in_time) {
  std::vector<CheckRow> rows = make_pipe_rows(line, model.description.checks);
  if (in_time && line.stations.empty() && !line.sections.empty()) {
    static constexpr CheckTitle kPipe = {"line_pipe", "Pipe of a line", "DNV-ST-F101, API RP 1111", "", "", ""};
    outside(rows.emplace_back(make_row(kPipe, CheckRegion::line)), "the run did not keep bending moments of lines");
  }
  const auto remark = [](CheckRow& row, const char* text) {
    row.remark += (row.remark.empty() ? "" : "; ") + std::string(text);
  };
  for (CheckRow& row : rows) {
    row.line = line.line;
    if (in_time && row.judged()) remark(row, "of the run; moment and tension of a point not simultaneous");
    if (row.id != "dnv_load_controlled" || !raises_factors_for_current(model.description)) continue;
    remark(row, "current included: all load effects have the environmental load factor");
  }
  return rows;
}

/// Returns the stations of lines with pipe; empty without any.
std::vector<CheckStations> collect_line_stations(const Model& model, const StaticResults& statics,
                                                 const DynamicResults* dynamics) {
  if (!statics.lift) return {};
  return dynamics == nullptr ? line_stations(model, *statics.lift)
                             : line_stations_in_time(model, statics, dynamics->lines);
}

/// Returns the checks of all objects. `dynamics`: run from that static state, or null.
CheckTable make_check_table(const Model& model, const StaticResults& statics, const DynamicResults* dynamics,
                            const CheckStations& all) {
  const CheckSettings& settings = model.description.checks;
  CheckTable table;
  table.rows = make_pipe_rows(all, settings);
  add_tip_remark(table.rows, statics);
  const auto pipe_rows = static_cast<std::ptrdiff_t>(table.rows.size());
  append(table.rows, equipment_rows(model, statics, dynamics));
  if (statics.moorings) append(table.rows, mooring_rows(model.description, *statics.moorings, dynamics));
  const std::vector<CheckStations> lines = collect_line_stations(model, statics, dynamics);
  for (const CheckStations& line : lines) append(table.rows, make_line_rows(line, model, dynamics != nullptr));
  append(table.rows, line_rows(model.description, statics.lines, dynamics != nullptr ? &dynamics->lines : nullptr));
  if (dynamics != nullptr && dynamics->duration < kThreeHours) {
    for (auto row = table.rows.begin(); row != table.rows.end(); ++row) {
      if (row->in_time || row - table.rows.begin() >= pipe_rows) add_duration_remark(*row, dynamics->duration);
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

/// Appends the table's assumptions to those of the results; checks that could not be evaluated become findings.
template <class Results>
void put(CheckTable table, Results& results) {
  const Assumptions& before = results.checks.assumptions;
  Assumptions& all = results.assumptions;
  if (all.size() >= before.size() && std::equal(before.rbegin(), before.rend(), all.rbegin())) {
    all.resize(all.size() - before.size());
  }
  all.insert(all.end(), table.assumptions.begin(), table.assumptions.end());
  std::erase_if(results.findings, [](const Finding& finding) { return finding.code == FindingCode::check_not_judged; });
  overbend::append(results.findings, find_invalid_checks(table));
  results.checks = std::move(table);
}

}  // namespace

CheckTable check_statics(const Model& model, const StaticResults& statics) {
  return make_check_table(model, statics, nullptr, static_stations(model, statics));
}

CheckTable check_dynamics(const Model& model, const StaticResults& statics, const DynamicResults& dynamics) {
  return make_check_table(model, statics, &dynamics, dynamic_stations(model, statics, dynamics));
}

void fill_checks(const Model& model, StaticResults& statics) {
  put(check_statics(model, statics), statics);
}

void fill_checks(const Model& model, const StaticResults& statics, DynamicResults& dynamics) {
  put(check_dynamics(model, statics, dynamics), dynamics);
}

}  // namespace overbend
