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

std::string row_words(const CheckSection& section) {
  std::string row = fmt::format("limit of {}", section.laying->grade);
  if (section.laying_exact) return row;
  return row + fmt::format(", the nearest lower grade of the table for {}", shown(section.smys, "Pa", 0));
}

/// A strain over the supports against a limit of the section's grade.
template <class Strain>
void judge_strain(CheckRow& row, const CheckStations& all, double LayingLimits::*limit, Strain strain) {
  const auto used = [&](const CheckStation& at) {
    const CheckSection& section = all.section_of(at);
    return section.laying ? strain(at) / ((*section.laying).*limit) : kLargestReserve;
  };
  const CheckStation* at = most_used(all, CheckRegion::overbend, used);
  const CheckSection& section = all.section_of(*at);
  place_row(row, *at);
  if (!section.laying) {
    outside(row, "the criteria start at X52");
    return;
  }
  judge_ratio(row, strain(*at), (*section.laying).*limit);
  row.remark = row_words(section);
  row.inputs = {{"eps", "longitudinal strain at the outer fibre", row.demand, "1"},
                {"SMYS", "specified minimum yield stress", section.smys, "Pa"}};
}

/// Limit of the table and utilisation, for a demand of the formula `demand`.
std::vector<SheetLine> strain_sheet(CalculationSheet sheet, const CheckRow& row, const char* demand) {
  sheet.computed(
      {"eps_lim", "allowed strain of the grade", "", "1", "sec. 13, " + row.remark, Confirmation::unconfirmed},
      row.capacity);
  sheet.computed({"U", "utilisation", std::string(demand) + "/eps_lim", "1", kSection13, Confirmation::unconfirmed},
                 row.utilisation);
  return sheet.lines;
}

CheckRow static_strain_row(const CheckStations& all) {
  CheckRow row = row_of(kStaticStrain, CheckRegion::overbend);
  judge_strain(row, all, &LayingLimits::static_strain, [](const CheckStation& at) { return at.strain; });
  if (!row.judged()) return row;
  CalculationSheet sheet;
  sheet.given("eps", "largest longitudinal strain", row.demand, "1", "static state");
  row.sheet = strain_sheet(std::move(sheet), row, "eps");
  return row;
}

CheckRow combined_strain_row(const CheckStations& all) {
  CheckRow row = row_of(kCombinedStrain, CheckRegion::overbend);
  if (!all.in_time) return not_done(row, "needs a dynamic analysis");
  const auto strain = [&](const CheckStation& at) {
    return all.section_of(at).strain_factor * at.largest_strain.value;
  };
  judge_strain(row, all, &LayingLimits::combined_strain, strain);
  const auto same = [&](const CheckStation& at) { return at.s == row.s; };
  const CheckStation& at = *std::find_if(all.stations.begin(), all.stations.end(), same);
  time_row(row, at.largest_strain.time);
  row.inputs.push_back({"SNCF", "strain factor of field joints", all.section_of(at).strain_factor, "1"});
  if (!row.judged()) return row;
  CalculationSheet sheet;
  sheet.given("eps", "largest longitudinal strain of the run", at.largest_strain.value, "1", "run");
  sheet.given("SNCF", "strain factor of field joints", all.section_of(at).strain_factor, "1",
              "pipe.joint.strain_factor");
  row.sheet = strain_sheet(std::move(sheet), row, "SNCF eps");
  return row;
}

/// Share of f_y or SMYS, by the basis of the limit.
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

/// The largest von Mises stress over a region against a limit that the section gives; `add_limit` puts the lines that
/// lead to it on the sheet.
template <class Limit, class AddLimit>
CheckRow stress_row(const CheckTitle& title, const CheckStations& all, CheckRegion region, Limit limit,
                    AddLimit add_limit) {
  CheckRow row = row_of(title, region);
  const CheckStation* at = most_used(all, region, [&](const CheckStation& station) {
    return station.largest_von_mises.value / limit(all.section_of(station));
  });
  place_row(row, *at);
  if (all.in_time) time_row(row, at->largest_von_mises.time);
  judge_ratio(row, at->largest_von_mises.value, limit(all.section_of(*at)));
  row.inputs = {{"sigma_eq", "von Mises stress", row.demand, "Pa"},
                {"SMYS", "specified minimum yield stress", all.section_of(*at).smys, "Pa"}};
  CalculationSheet sheet;
  sheet.given("sigma_eq", "von Mises stress, load factors 1", row.demand, "Pa", all.in_time ? "run" : "static state");
  add_limit(sheet, all.section_of(*at));
  sheet.computed({"U", "utilisation", "sigma_eq/sigma_lim", "1", title.clause}, row.utilisation);
  row.sheet = std::move(sheet.lines);
  return row;
}

bool has(const CheckStations& all, CheckRegion region) {
  return most_used(all, region, [](const CheckStation&) { return 0.0; }) != nullptr;
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

/// The overbend of the results has its free end as well; of a J-lay the tower stands for it.
void add_upper_share(std::vector<CheckRow>& rows, const CheckStations& all, const std::optional<double>& share) {
  const std::size_t before = rows.size();
  for (const CheckRegion region : {CheckRegion::tower, CheckRegion::overbend, CheckRegion::tip}) {
    add_share(rows, all, region, share);
  }
  if (share && rows.size() == before) {
    rows.push_back(not_done(row_of(kShare, CheckRegion::overbend), "the line has no overbend"));
  }
}

/// The static state of a run, so that its static limits can be checked beside the dynamic ones.
CheckStations at_rest(const CheckStations& all) {
  CheckStations rest = all;
  rest.in_time = false;
  for (CheckStation& station : rest.stations) station.largest_von_mises = {station.von_mises, 0.0};
  return rest;
}

}  // namespace

std::vector<CheckRow> laying_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows;
  const YieldShares& share = settings.yield_share;
  if (settings.codes != CheckCodes::api && has(all, CheckRegion::overbend)) {
    rows.push_back(static_strain_row(all));
    rows.push_back(combined_strain_row(all));
  }
  for (const CheckRegion region : judged_regions(all)) {
    if (settings.codes == CheckCodes::api || region == CheckRegion::overbend || !has(all, region)) continue;
    rows.push_back(stress_row(
        kStress, all, region, [](const CheckSection& s) { return s.stress_limit; },
        [&](CalculationSheet& sheet, const CheckSection& s) { add_stress_limit(sheet, s, settings); }));
  }
  if (!all.line.empty()) {
    if (share.overbend_static || share.sagbend_static) {
      rows.push_back(not_done(row_of(kShare, CheckRegion::line), "its limits are those of overbend and sagbend"));
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
