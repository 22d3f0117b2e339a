#include <cmath>

#include "checks/check_row.h"
#include "checks/check_rows.h"
#include "checks/dnv_sheet.h"

namespace overbend {
namespace {

constexpr CheckTitle kCollapse = {"dnv_collapse", "Collapse under external pressure", kDnv,
                                  "5.4.4",        "external minus internal pressure", "Pa"};
constexpr CheckTitle kPropagation = {"dnv_propagation", "Propagation of a buckle",          kDnv,
                                     "5.4.5",           "external minus internal pressure", "Pa"};
constexpr CheckTitle kCrossover = {"dnv_crossover", "Cross-over of the buckle arrestor", kDnv,
                                   "5.4.5",         "external minus internal pressure",  "Pa"};
constexpr CheckTitle kLoad = {
    "dnv_load_controlled", "Local buckling, load controlled", kDnv, "5.4.6", "design bending moment", "N m"};
constexpr CheckTitle kBend = {
    "dnv_displacement_controlled", "Local buckling, displacement controlled", kDnv, "5.4.6", "design strain", "1"};

/// Check of a pressure, and the station of maximum utilisation.
struct PressureCheck {
  CheckRow row;
  const CheckStation& station;
};

/// Checks a pressure along the line against a capacity of the section.
template <class Capacity>
PressureCheck pressure_check(const CheckTitle& title, const CheckStations& all, Capacity capacity) {
  CheckRow row = make_row(title, CheckRegion::line);
  const CheckStation* worst = find_governing_station(all, CheckRegion::line, [&](const CheckStation& station) {
    return station.overpressure / capacity(all.section_for(station));
  });
  set_row_location(row, *worst);
  set_utilisation(row, std::max(worst->overpressure, 0.0), capacity(all.section_for(*worst)));
  return {std::move(row), *worst};
}

CheckRow collapse_row(const CheckStations& all, const CheckSettings& settings) {
  auto [row, station] =
      pressure_check(kCollapse, all, [](const CheckSection& s) { return s.collapse_thinnest / s.factor; });
  const CheckSection& section = all.section_for(station);
  row.inputs = {{"p_c(t1)", "collapse pressure", section.collapse_thinnest, "Pa"},
                {"t1", "wall thickness minus tolerance", section.thinnest, "m"},
                {"f_y", "characteristic yield stress", section.fy, "Pa"},
                {"alpha_fab", "fabrication factor", section.alpha_fab, "1"},
                {"O_0", "ovality", settings.ovality, "1"},
                {"gamma_m gamma_SC", "resistance factors", section.factor, "1"}};
  row.sheet = dnv_collapse_sheet(all, station, settings, row.utilisation);
  return row;
}

CheckRow propagation_row(const CheckStations& all, const CheckSettings& settings) {
  auto [row, station] =
      pressure_check(kPropagation, all, [](const CheckSection& s) { return s.propagation / s.factor; });
  const CheckSection& section = all.section_for(station);
  row.governing = false;
  row.inputs = {{"p_pr(t2)", "propagation pressure", section.propagation, "Pa"},
                {"t2", "wall", section.wall.thickness, "m"},
                {"gamma_m gamma_SC", "resistance factors", section.factor, "1"}};
  row.sheet = dnv_propagation_sheet(all, station, settings, row.utilisation);
  const auto beyond = [](const CheckSection& s) {
    return s.wall.slenderness() <= 15.0 || s.wall.slenderness() >= 45.0;
  };
  if (any_section(all, CheckRegion::line, beyond)) {
    outside(row, "valid for 15 < D/t2 < 45");
  } else if (row.status == CheckStatus::exceeded) {
    row.remark = "a buckle would propagate: buckle arrestors are needed";
  }
  return row;
}

CheckRow crossover_row(const CheckStations& all, const CheckSettings& settings) {
  const ArrestorSettings& arrestor = *settings.arrestor;
  const auto pressure = [&](const CheckSection& s) {
    return crossover_pressure(s.wall, s.propagation, arrestor.propagation_pressure, arrestor.length);
  };
  auto [row, station] =
      pressure_check(kCrossover, all, [&](const CheckSection& s) { return pressure(s) / (1.1 * s.factor); });
  row.inputs = {{"p_X", "cross-over pressure", pressure(all.section_for(station)), "Pa"},
                {"p_BA", "propagation pressure of the arrestor", arrestor.propagation_pressure, "Pa"},
                {"L_BA", "length of the arrestor", arrestor.length, "m"}};
  row.sheet = dnv_crossover_sheet(all, station, settings, row.utilisation);
  return row;
}

std::vector<CheckInput> load_inputs(const CheckSection& section, const CheckStation& station) {
  return {{"M_F", "functional (static) moment", station.moment, "N m"},
          {"S_F", "functional (static) effective force", station.force, "N"},
          {"M_Sd", "design bending moment", station.design_moment, "N m"},
          {"S_Sd", "design effective force", station.design_force, "N"},
          {"p_e - p_i", "external minus internal pressure", station.load_pressure, "Pa"},
          {"p_c(t2)", "collapse pressure", section.collapse, "Pa"},
          {"alpha_c", "flow stress factor", section.load.alpha_c, "1"},
          {"alpha_pm", "reduction of the plastic moment by a roller", station.share, "1"},
          {"M_p", "plastic moment", plastic_moment(section.wall, section.fy), "N m"},
          {"S_p", "plastic axial force", plastic_axial_force(section.wall, section.fy), "N"},
          {"gamma_m gamma_SC", "resistance factors", section.factor, "1"}};
}

/// Returns the station nearest to the validity limit at which the formula is not valid; null if it is valid everywhere.
const CheckStation* find_invalid_station(const CheckStations& all, CheckRegion region) {
  const CheckStation* governing = find_governing_station(all, region, [&](const CheckStation& station) {
    const LoadCapacity& capacity = all.section_for(station).load;
    return capacity.slender_enough ? station.max_force / capacity.axial_limit : kMaxReserve;
  });
  return load_formula_holds(all.section_for(*governing).load, governing->max_force) ? nullptr : governing;
}

std::string load_validity_message(const CheckSection& section) {
  return section.load.slender_enough ? "valid for an effective force below 0.4 S_p" : "valid for 15 <= D/t2 <= 45";
}

CheckRow load_row(const CheckStations& all, CheckRegion region, const CheckSettings& settings) {
  CheckRow row = make_row(kLoad, region);
  row.governing = region != CheckRegion::overbend;
  const CheckStation* governing =
      find_governing_station(all, region, [](const CheckStation& station) { return station.load.value; });
  const CheckSection& section = all.section_for(*governing);
  if (any_section(all, region, [](const CheckSection& s) { return !s.load.known; })) {
    return not_done(row, "tensile strength not given");
  }
  const LoadTerms terms = load_terms(section.load, governing->design_moment, governing->design_force,
                                     governing->load_pressure, 0.0, governing->share);
  set_row_location(row, *governing);
  if (all.in_time) set_row_time(row, governing->load.time);
  row.inputs = load_inputs(section, *governing);
  row.demand = governing->design_moment;
  row.capacity = std::max(0.0, std::sqrt(std::max(0.0, 1.0 - terms.pressure)) - terms.axial * terms.axial) *
                 governing->share / section.load.moment_factor;
  row.utilisation = terms.utilisation();
  row.reserve = load_reserve(terms);
  row.sheet = dnv_load_sheet(all, *governing, settings, terms);
  set_row_verdict(row);
  if (!row.governing) row.remark = "the pipe conforms to the supports, the strain governs";
  if (const CheckStation* beyond = find_invalid_station(all, region)) {
    outside(row, load_validity_message(all.section_for(*beyond)));
  }
  return row;
}

constexpr const char* kBendHolds = "valid for D/t2 < 45";

CheckRow bend_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = make_row(kBend, CheckRegion::overbend);
  const CheckStation* governing = find_governing_station(
      all, CheckRegion::overbend, [](const CheckStation& station) { return station.bend.value; });
  const CheckSection& section = all.section_for(*governing);
  const double raised = internal_pressure_factor(-governing->bend_pressure, section.strain.burst);
  set_row_location(row, *governing);
  row.inputs = {{"eps_F", "functional (static) strain", governing->strain, "1"},
                {"eps_Sd", "design strain", governing->design_strain, "1"},
                {"SNCF", "strain factor of field joints", section.strain_factor, "1"},
                {"eps_c", "strain capacity", section.strain_capacity * raised, "1"},
                {"p_e - p_i", "external minus internal pressure", governing->bend_pressure, "Pa"},
                {"p_c(t2)", "collapse pressure", section.collapse, "Pa"}};
  if (!section.strain.holds) {
    outside(row, kBendHolds);
    return row;
  }
  if (all.in_time) set_row_time(row, governing->bend.time);
  const StrainTerms terms = strain_terms(section.strain, governing->design_strain, governing->bend_pressure, 0.0);
  row.demand = governing->design_strain;
  row.utilisation = terms.utilisation();
  row.reserve = terms.reserve();
  row.sheet = dnv_strain_sheet(all, *governing, settings, terms);
  row.capacity =
      raised * std::pow(std::max(0.0, 1.0 - terms.pressure), 1.0 / terms.exponent) / section.strain.strain_factor;
  set_row_verdict(row);
  if (any_section(all, CheckRegion::overbend, [](const CheckSection& s) { return !s.strain.holds; })) {
    outside(row, kBendHolds);
  }
  return row;
}

}  // namespace

std::vector<CheckRow> dnv_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows = {collapse_row(all, settings), propagation_row(all, settings)};
  if (settings.arrestor) rows.push_back(crossover_row(all, settings));
  for (const CheckRegion region : checked_regions(all)) {
    if (find_governing_station(all, region, [](const CheckStation&) { return 0.0; }) == nullptr) continue;
    if (region == CheckRegion::overbend) rows.push_back(bend_row(all, settings));
    rows.push_back(load_row(all, region, settings));
  }
  return rows;
}

}  // namespace overbend
