#include <cmath>

#include "checks/api_sheet.h"
#include "checks/check_row.h"
#include "checks/check_rows.h"

namespace overbend {
namespace {

const char* edition(const CheckSettings& settings) {
  constexpr std::array kEditions = {"API RP 1111 (3rd, 1999)", "API RP 1111 (4th, 2009)", "API RP 1111 (5th, 2015)"};
  return kEditions[static_cast<std::size_t>(settings.api.edition)];
}

CheckRow row_of_api(const char* id, const char* name, const char* clause, const char* quantity, const char* units,
                    CheckRegion region, const CheckSettings& settings) {
  return row_of({id, name, edition(settings), clause, quantity, units}, region);
}

CheckRow collapse_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = row_of_api("api_collapse", "Collapse under external pressure", "4.3.2.1",
                            "external minus internal pressure", "Pa", CheckRegion::line, settings);
  const auto limit = [](const CheckSection& s) { return s.api_collapse_share * api_collapse_pressure(s.api); };
  const CheckStation* at = most_used(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.overpressure / limit(all.section_of(station));
  });
  const CheckSection& section = all.section_of(*at);
  place_row(row, *at);
  judge_ratio(row, std::max(at->overpressure, 0.0), limit(section));
  row.inputs = {{"P_c", "collapse pressure", api_collapse_pressure(section.api), "Pa"},
                {"f_o", "collapse factor", section.api_collapse_share, "1"}};
  row.sheet = api_collapse_sheet(all, *at, settings, row.utilisation);
  return row;
}

CheckRow propagation_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = row_of_api("api_propagation", "Propagation of a buckle", "4.3.2.3", "external minus internal pressure",
                            "Pa", CheckRegion::line, settings);
  const auto limit = [](const CheckSection& s) { return kApiPropagationFactor * api_propagation_pressure(s.api); };
  const CheckStation* at = most_used(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.overpressure / limit(all.section_of(station));
  });
  row.governing = false;
  place_row(row, *at);
  judge_ratio(row, std::max(at->overpressure, 0.0), limit(all.section_of(*at)));
  row.inputs = {{"P_p", "propagation pressure", api_propagation_pressure(all.section_of(*at).api), "Pa"}};
  row.sheet = api_propagation_sheet(all, *at, row.utilisation);
  if (row.status == CheckStatus::exceeded) {
    row.remark = "a buckle would propagate: buckle arrestors are needed";
  }
  return row;
}

CheckRow bending_row(const CheckStations& all, CheckRegion region, const CheckSettings& settings) {
  CheckRow row = row_of_api("api_bending_pressure", "Bending and external pressure", "4.3.2.2", "strain times f_1", "1",
                            region, settings);
  const CheckStation* at =
      most_used(all, region, [&](const CheckStation& station) { return api_bending_at(all, station, settings); });
  const CheckSection& section = all.section_of(*at);
  place_row(row, *at);
  if (all.in_time) time_row(row, at->largest_strain.time);
  const double pressure =
      std::max(at->overpressure, 0.0) / (section.api_pressure_factor * api_collapse_pressure(section.api));
  const double g = api_ovality_factor(section.api_delta), buckling = api_buckling_strain(section.api);
  row.demand = settings.api.bending_factor * section.strain_factor * at->largest_strain.value;
  row.capacity = std::max(0.0, g - pressure) * buckling;
  row.utilisation = api_bending_at(all, *at, settings);
  row.reserve = row.demand > 0.0 ? std::min(row.capacity / row.demand, kLargestReserve) : kLargestReserve;
  row.inputs = {{"eps_1", "installation strain", at->largest_strain.value, "1"},
                {"f_1", "bending factor", settings.api.bending_factor, "1"},
                {"SAF", "strain factor of field joints", section.strain_factor, "1"},
                {"eps_b", "buckling strain", buckling, "1"},
                {"P_o - P_i", "external minus internal pressure", at->overpressure, "Pa"},
                {"f_c", "factor on collapse pressure", section.api_pressure_factor, "1"},
                {"delta", "ovality according to API", section.api_delta, "1"}};
  row.sheet = api_bending_sheet(all, *at, settings, row.utilisation);
  judge(row);
  if (any_section(all, region, [](const CheckSection& s) { return s.wall.slenderness() > kApiMostSlender; })) {
    outside(row, "valid for D/t <= 50");
  }
  return row;
}

CheckRow tension_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row =
      row_of_api("api_tension", "Longitudinal load", "4.3.1.1", "effective tension", "N", CheckRegion::line, settings);
  const auto limit = [](const CheckSection& s) { return kApiTensionFactor * api_yield_tension(s.api); };
  const CheckStation* at = most_used(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.largest_tension.value / limit(all.section_of(station));
  });
  place_row(row, *at);
  if (all.in_time) time_row(row, at->largest_tension.time);
  judge_ratio(row, std::max(at->largest_tension.value, 0.0), limit(all.section_of(*at)));
  row.inputs = {{"T_y", "yield tension", api_yield_tension(all.section_of(*at).api), "N"}};
  row.sheet = api_tension_sheet(all, *at, row.utilisation);
  return row;
}

CheckRow combined_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = row_of_api("api_combined_load", "Combined pressure and tension", "4.3.1.2", "combined load", "1",
                            CheckRegion::line, settings);
  const auto missing = [](const CheckSection& section) { return section.smts <= 0.0; };
  if (std::any_of(all.sections.begin(), all.sections.end(), missing)) {
    return not_done(row, "tensile strength not given");
  }
  const auto load = [&](const CheckStation& at) {
    const CheckSection& section = all.section_of(at);
    return api_combined_load(section.api, section.smts, at.overpressure, at.largest_tension.value);
  };
  const CheckStation* at = most_used(all, CheckRegion::line, load);
  place_row(row, *at);
  if (all.in_time) time_row(row, at->largest_tension.time);
  judge_ratio(row, load(*at), all.in_time ? kApiExtremeLimit : kApiFunctionalLimit);
  row.remark = all.in_time ? "limit for extreme loads" : "limit for functional loads";
  row.inputs = {{"T_eff", "effective tension", at->largest_tension.value, "N"},
                {"P_o - P_i", "external minus internal pressure", at->overpressure, "Pa"},
                {"P_b", "burst pressure", api_burst_pressure(all.section_of(*at).api, all.section_of(*at).smts), "Pa"}};
  row.sheet = api_combined_sheet(all, *at, row.capacity, row.utilisation);
  return row;
}

}  // namespace

double api_bending_at(const CheckStations& all, const CheckStation& station, const CheckSettings& settings) {
  const CheckSection& section = all.section_of(station);
  const double strain = settings.api.bending_factor * section.strain_factor * station.largest_strain.value;
  return api_bending_utilisation(section.api, strain, station.overpressure, section.api_pressure_factor,
                                 section.api_delta);
}

std::vector<CheckRow> api_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows = {collapse_row(all, settings), propagation_row(all, settings), tension_row(all, settings),
                                combined_row(all, settings)};
  for (const CheckRegion region : judged_regions(all)) {
    if (most_used(all, region, [](const CheckStation&) { return 0.0; }) == nullptr) continue;
    rows.push_back(bending_row(all, region, settings));
  }
  return rows;
}

}  // namespace overbend
