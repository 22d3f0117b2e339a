#include <fmt/format.h>

#include "base/shown_unit.h"
#include "checks/calculation_sheet.h"
#include "checks/check_row.h"
#include "checks/check_rows.h"
#include "checks/dnv_section_lines.h"

namespace overbend {
namespace {

constexpr const char* kSection13 = "sec. 13";
constexpr CheckTitle kStaticStrain = {
    "dnv_criterion_1", "Laying criterion I, static strain", kDnv, kSection13, "longitudinal strain", "1"};
constexpr CheckTitle kCombinedStrain = {
    "dnv_criterion_2", "Laying criterion II, static and dynamic strain", kDnv, kSection13, "longitudinal strain", "1"};
constexpr CheckTitle kStress = {
    "dnv_equivalent_stress", "Equivalent stress, 0.87 f_y", kDnv, kSection13, "von Mises stress", "Pa"};

std::string limit_label(const CheckSection& section) {
  std::string row = fmt::format("limit of {}", section.laying->grade);
  if (section.laying_exact) return row;
  return row + fmt::format(", the nearest lower grade of the table for {}", shown(section.smys, "Pa", 0));
}

/// Checks a strain over the supports against a limit of the section's grade.
template <class Strain>
void check_strain(CheckRow& row, const CheckStations& all, double LayingLimits::*limit, Strain strain) {
  const auto used = [&](const CheckStation& station) {
    const CheckSection& section = all.section_for(station);
    return section.laying ? strain(station) / ((*section.laying).*limit) : kMaxReserve;
  };
  const CheckStation* governing = find_governing_station(all, CheckRegion::overbend, used);
  const CheckSection& section = all.section_for(*governing);
  set_row_location(row, *governing);
  if (!section.laying) {
    outside(row, "the criteria start at X52");
    return;
  }
  set_utilisation(row, strain(*governing), (*section.laying).*limit);
  row.remark = limit_label(section);
  row.inputs = {{"eps", "longitudinal strain at the outer fibre", row.demand, "1"},
                {"SMYS", "specified minimum yield stress", section.smys, "Pa"}};
}

/// Returns the lines for the limit of the table and the utilisation, for a demand of the formula `demand`.
std::vector<SheetLine> strain_sheet(CalculationSheet sheet, const CheckRow& row, const char* demand) {
  sheet.computed(
      {"eps_lim", "allowed strain of the grade", "", "1", "sec. 13, " + row.remark, Confirmation::unconfirmed},
      row.capacity);
  sheet.computed({"U", "utilisation", std::string(demand) + "/eps_lim", "1", kSection13, Confirmation::unconfirmed},
                 row.utilisation);
  return sheet.lines;
}

CheckRow static_strain_row(const CheckStations& all) {
  CheckRow row = make_row(kStaticStrain, CheckRegion::overbend);
  check_strain(row, all, &LayingLimits::static_strain, [](const CheckStation& station) { return station.strain; });
  if (!row.judged()) return row;
  CalculationSheet sheet;
  sheet.given("eps", "largest longitudinal strain", row.demand, "1", "static state");
  row.sheet = strain_sheet(std::move(sheet), row, "eps");
  return row;
}

CheckRow combined_strain_row(const CheckStations& all) {
  CheckRow row = make_row(kCombinedStrain, CheckRegion::overbend);
  if (!all.in_time) return not_done(row, "needs a dynamic analysis");
  const auto strain = [&](const CheckStation& station) {
    return all.section_for(station).strain_factor * station.max_strain.value;
  };
  check_strain(row, all, &LayingLimits::combined_strain, strain);
  const auto same = [&](const CheckStation& station) { return station.s == row.s; };
  const CheckStation& governing = *std::find_if(all.stations.begin(), all.stations.end(), same);
  set_row_time(row, governing.max_strain.time);
  row.inputs.push_back({"SNCF", "strain factor of field joints", all.section_for(governing).strain_factor, "1"});
  if (!row.judged()) return row;
  CalculationSheet sheet;
  sheet.given("eps", "largest longitudinal strain of the run", governing.max_strain.value, "1", "run");
  sheet.given("SNCF", "strain factor of field joints", all.section_for(governing).strain_factor, "1",
              "pipe.joint.strain_factor");
  row.sheet = strain_sheet(std::move(sheet), row, "SNCF eps");
  return row;
}

/// Adds f_y or SMYS, the basis of the limit.
void add_stress_limit(CalculationSheet& sheet, const CheckSection& section, const CheckSettings& settings) {
  const bool fy = settings.yield_basis == YieldBasis::fy;
  if (fy) {
    add_yield_strength(sheet, section, settings);
  } else {
    sheet.given("SMYS", "specified minimum yield stress, f_y here (checks.yield_basis)", section.smys, "Pa",
                "steel.yield_stress");
  }
  sheet.computed({"sigma_lim", "allowed equivalent stress", fy ? "0.87 f_y" : "0.87 SMYS", "Pa", kSection13,
                  Confirmation::unconfirmed},
                 section.stress_limit);
}

void add_share_limit(CalculationSheet& sheet, const CheckSection& section, double share) {
  sheet.given("SMYS", "specified minimum yield stress", section.smys, "Pa", "steel.yield_stress");
  sheet.given("k", "allowed fraction of SMYS", share, "1", "checks.yield_share");
  sheet.computed({"sigma_lim", "allowed von Mises stress", "k SMYS", "Pa", "project limit"}, share * section.smys);
}

/// Checks the maximum von Mises stress over a region against a limit of the section; `add_limit` adds the sheet lines
/// that lead to it.
template <class Limit, class AddLimit>
CheckRow stress_row(const CheckTitle& title, const CheckStations& all, CheckRegion region, Limit limit,
                    AddLimit add_limit) {
  CheckRow row = make_row(title, region);
  const CheckStation* governing = find_governing_station(all, region, [&](const CheckStation& station) {
    return station.max_von_mises.value / limit(all.section_for(station));
  });
  set_row_location(row, *governing);
  if (all.in_time) set_row_time(row, governing->max_von_mises.time);
  set_utilisation(row, governing->max_von_mises.value, limit(all.section_for(*governing)));
  row.inputs = {{"sigma_eq", "von Mises stress", row.demand, "Pa"},
                {"SMYS", "specified minimum yield stress", all.section_for(*governing).smys, "Pa"}};
  CalculationSheet sheet;
  sheet.given("sigma_eq", "von Mises stress, load factors 1", row.demand, "Pa", all.in_time ? "run" : "static state");
  add_limit(sheet, all.section_for(*governing));
  sheet.computed({"U", "utilisation", "sigma_eq/sigma_lim", "1", title.clause}, row.utilisation);
  row.sheet = std::move(sheet.lines);
  return row;
}

bool has(const CheckStations& all, CheckRegion region) {
  return find_governing_station(all, region, [](const CheckStation&) { return 0.0; }) != nullptr;
}

constexpr CheckTitle kShare = {"yield_share", "Fraction of yield stress", "project limit", "", "von Mises stress",
                               "Pa"};

void add_share(std::vector<CheckRow>& rows, const CheckStations& all, CheckRegion region,
               const std::optional<double>& share) {
  if (!share || !has(all, region)) return;
  rows.push_back(stress_row(
      kShare, all, region, [&](const CheckSection& s) { return *share * s.smys; },
      [&](CalculationSheet& sheet, const CheckSection& s) { add_share_limit(sheet, s, *share); }));
  rows.back().remark = fmt::format("limit {:.4g} % of SMYS{}", 100.0 * *share, all.in_time ? ", dynamic" : ", static");
}

/// The overbend of the results includes the free end; for a J-lay it is the tower.
void add_upper_share(std::vector<CheckRow>& rows, const CheckStations& all, const std::optional<double>& share) {
  const std::size_t before = rows.size();
  for (const CheckRegion region : {CheckRegion::tower, CheckRegion::overbend, CheckRegion::tip}) {
    add_share(rows, all, region, share);
  }
  if (share && rows.size() == before) {
    rows.push_back(not_done(make_row(kShare, CheckRegion::overbend), "the line has no overbend"));
  }
}

/// Returns the static state of a run, to check its static limits together with the dynamic ones.
CheckStations at_rest(const CheckStations& all) {
  CheckStations rest = all;
  rest.in_time = false;
  for (CheckStation& station : rest.stations) station.max_von_mises = {station.von_mises, 0.0};
  return rest;
}

}  // namespace

std::vector<CheckRow> laying_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows;
  const AllowableStressFactors& share = settings.allowable_stress;
  if (settings.codes != CheckCodes::api && has(all, CheckRegion::overbend)) {
    rows.push_back(static_strain_row(all));
    rows.push_back(combined_strain_row(all));
  }
  for (const CheckRegion region : checked_regions(all)) {
    if (settings.codes == CheckCodes::api || region == CheckRegion::overbend || !has(all, region)) continue;
    rows.push_back(stress_row(
        kStress, all, region, [](const CheckSection& s) { return s.stress_limit; },
        [&](CalculationSheet& sheet, const CheckSection& s) { add_stress_limit(sheet, s, settings); }));
  }
  if (!all.line.empty()) {
    if (share.overbend_static || share.sagbend_static) {
      rows.push_back(not_done(make_row(kShare, CheckRegion::line), "its limits are those of overbend and sagbend"));
    }
    return rows;
  }
  const CheckStations rest = at_rest(all);
  add_upper_share(rows, rest, share.overbend_static);
  add_share(rows, rest, CheckRegion::sagbend, share.sagbend_static);
  if (all.in_time) {
    add_upper_share(rows, all, share.overbend_dynamic);
    add_share(rows, all, CheckRegion::sagbend, share.sagbend_dynamic);
  }
  return rows;
}

}  // namespace overbend
