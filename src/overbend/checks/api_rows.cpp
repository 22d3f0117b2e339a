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

CheckRow make_api_row(const char* id, const char* name, const char* clause, const char* quantity, const char* units,
                      CheckRegion region, const CheckSettings& settings) {
  return make_row({id, name, edition(settings), clause, quantity, units}, region);
}

CheckRow collapse_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = make_api_row("api_collapse", "Collapse under external pressure", "4.3.2.1",
                              "external minus internal pressure", "Pa", CheckRegion::line, settings);
  const auto limit = [](const CheckSection& s) { return s.api_collapse_share * api_collapse_pressure(s.api); };
  const CheckStation* governing = find_governing_station(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.overpressure / limit(all.section_for(station));
  });
  const CheckSection& section = all.section_for(*governing);
  set_row_location(row, *governing);
  set_utilisation(row, std::max(governing->overpressure, 0.0), limit(section));
  row.inputs = {{"P_c", "collapse pressure", api_collapse_pressure(section.api), "Pa"},
                {"f_o", "collapse factor", section.api_collapse_share, "1"}};
  row.sheet = api_collapse_sheet(all, *governing, settings, row.utilisation);
  return row;
}

CheckRow propagation_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = make_api_row("api_propagation", "Propagation of a buckle", "4.3.2.3",
                              "external minus internal pressure", "Pa", CheckRegion::line, settings);
  const auto limit = [](const CheckSection& s) { return kApiPropagationFactor * api_propagation_pressure(s.api); };
  const CheckStation* governing = find_governing_station(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.overpressure / limit(all.section_for(station));
  });
  row.governing = false;
  set_row_location(row, *governing);
  set_utilisation(row, std::max(governing->overpressure, 0.0), limit(all.section_for(*governing)));
  row.inputs = {{"P_p", "propagation pressure", api_propagation_pressure(all.section_for(*governing).api), "Pa"}};
  row.sheet = api_propagation_sheet(all, *governing, row.utilisation);
  if (row.status == CheckStatus::exceeded) {
    row.remark = "a buckle would propagate: buckle arrestors are needed";
  }
  return row;
}

CheckRow bending_row(const CheckStations& all, CheckRegion region, const CheckSettings& settings) {
  CheckRow row = make_api_row("api_bending_pressure", "Bending and external pressure", "4.3.2.2", "strain times f_1",
                              "1", region, settings);
  const CheckStation* governing = find_governing_station(
      all, region, [&](const CheckStation& station) { return api_bending_at(all, station, settings); });
  const CheckSection& section = all.section_for(*governing);
  set_row_location(row, *governing);
  if (all.in_time) set_row_time(row, governing->max_strain.time);
  const double pressure =
      std::max(governing->overpressure, 0.0) / (section.api_pressure_factor * api_collapse_pressure(section.api));
  const double g = api_ovality_factor(section.api_delta), buckling = api_buckling_strain(section.api);
  row.demand = settings.api.bending_factor * section.strain_factor * governing->max_strain.value;
  row.capacity = std::max(0.0, g - pressure) * buckling;
  row.utilisation = api_bending_at(all, *governing, settings);
  row.reserve = row.demand > 0.0 ? std::min(row.capacity / row.demand, kMaxReserve) : kMaxReserve;
  row.inputs = {{"eps_1", "installation strain", governing->max_strain.value, "1"},
                {"f_1", "bending factor", settings.api.bending_factor, "1"},
                {"SAF", "strain factor of field joints", section.strain_factor, "1"},
                {"eps_b", "buckling strain", buckling, "1"},
                {"P_o - P_i", "external minus internal pressure", governing->overpressure, "Pa"},
                {"f_c", "factor on collapse pressure", section.api_pressure_factor, "1"},
                {"delta", "ovality according to API", section.api_delta, "1"}};
  row.sheet = api_bending_sheet(all, *governing, settings, row.utilisation);
  set_row_verdict(row);
  if (any_section(all, region, [](const CheckSection& s) { return s.wall.slenderness() > kMaxApiSlenderness; })) {
    outside(row, "valid for D/t <= 50");
  }
  return row;
}

CheckRow tension_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = make_api_row("api_tension", "Longitudinal load", "4.3.1.1", "effective tension", "N",
                              CheckRegion::line, settings);
  const auto limit = [](const CheckSection& s) { return kApiTensionFactor * api_yield_tension(s.api); };
  const CheckStation* governing = find_governing_station(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.max_tension.value / limit(all.section_for(station));
  });
  set_row_location(row, *governing);
  if (all.in_time) set_row_time(row, governing->max_tension.time);
  set_utilisation(row, std::max(governing->max_tension.value, 0.0), limit(all.section_for(*governing)));
  row.inputs = {{"T_y", "yield tension", api_yield_tension(all.section_for(*governing).api), "N"}};
  row.sheet = api_tension_sheet(all, *governing, row.utilisation);
  return row;
}

CheckRow combined_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = make_api_row("api_combined_load", "Combined pressure and tension", "4.3.1.2", "combined load", "1",
                              CheckRegion::line, settings);
  const auto missing = [](const CheckSection& section) { return section.smts <= 0.0; };
  if (std::any_of(all.sections.begin(), all.sections.end(), missing)) {
    return not_done(row, "tensile strength not given");
  }
  const auto load = [&](const CheckStation& station) {
    const CheckSection& section = all.section_for(station);
    return api_combined_load(section.api, section.smts, station.overpressure, station.max_tension.value);
  };
  const CheckStation* governing = find_governing_station(all, CheckRegion::line, load);
  set_row_location(row, *governing);
  if (all.in_time) set_row_time(row, governing->max_tension.time);
  set_utilisation(row, load(*governing), all.in_time ? kApiExtremeLimit : kApiFunctionalLimit);
  row.remark = all.in_time ? "limit for extreme loads" : "limit for functional loads";
  row.inputs = {{"T_eff", "effective tension", governing->max_tension.value, "N"},
                {"P_o - P_i", "external minus internal pressure", governing->overpressure, "Pa"},
                {"P_b", "burst pressure",
                 api_burst_pressure(all.section_for(*governing).api, all.section_for(*governing).smts), "Pa"}};
  row.sheet = api_combined_sheet(all, *governing, row.capacity, row.utilisation);
  return row;
}

}  // namespace

double api_bending_at(const CheckStations& all, const CheckStation& station, const CheckSettings& settings) {
  const CheckSection& section = all.section_for(station);
  const double strain = settings.api.bending_factor * section.strain_factor * station.max_strain.value;
  return api_bending_utilisation(section.api, strain, station.overpressure, section.api_pressure_factor,
                                 section.api_delta);
}

std::vector<CheckRow> api_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows = {collapse_row(all, settings), propagation_row(all, settings), tension_row(all, settings),
                                combined_row(all, settings)};
  for (const CheckRegion region : checked_regions(all)) {
    if (find_governing_station(all, region, [](const CheckStation&) { return 0.0; }) == nullptr) continue;
    rows.push_back(bending_row(all, region, settings));
  }
  return rows;
}

}  // namespace overbend
