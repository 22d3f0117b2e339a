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

/// A check of a pressure, and the station where it is used most.
struct PressureCheck {
  CheckRow row;
  const CheckStation& station;
};

/// A pressure along the line against a capacity of the section.
template <class Capacity>
PressureCheck pressure_check(const CheckTitle& title, const CheckStations& all, Capacity capacity) {
  CheckRow row = row_of(title, CheckRegion::line);
  const CheckStation* worst = most_used(
      all, CheckRegion::line, [&](const CheckStation& at) { return at.overpressure / capacity(all.section_of(at)); });
  place_row(row, *worst);
  judge_ratio(row, std::max(worst->overpressure, 0.0), capacity(all.section_of(*worst)));
  return {std::move(row), *worst};
}

CheckRow collapse_row(const CheckStations& all, const CheckSettings& settings) {
  auto [row, station] =
      pressure_check(kCollapse, all, [](const CheckSection& s) { return s.collapse_thinnest / s.factor; });
  const CheckSection& section = all.section_of(station);
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
  const CheckSection& section = all.section_of(station);
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
  row.inputs = {{"p_X", "cross-over pressure", pressure(all.section_of(station)), "Pa"},
                {"p_BA", "propagation pressure of the arrestor", arrestor.propagation_pressure, "Pa"},
                {"L_BA", "length of the arrestor", arrestor.length, "m"}};
  row.sheet = dnv_crossover_sheet(all, station, settings, row.utilisation);
  return row;
}

std::vector<CheckInput> load_inputs(const CheckSection& section, const CheckStation& at) {
  return {{"M_F", "functional (static) moment", at.moment, "N m"},
          {"S_F", "functional (static) effective force", at.force, "N"},
          {"M_Sd", "design bending moment", at.design_moment, "N m"},
          {"S_Sd", "design effective force", at.design_force, "N"},
          {"p_e - p_i", "external minus internal pressure", at.load_pressure, "Pa"},
          {"p_c(t2)", "collapse pressure", section.collapse, "Pa"},
          {"alpha_c", "flow stress factor", section.load.alpha_c, "1"},
          {"alpha_pm", "reduction of the plastic moment by a roller", at.share, "1"},
          {"M_p", "plastic moment", plastic_moment(section.wall, section.fy), "N m"},
          {"S_p", "plastic axial force", plastic_axial_force(section.wall, section.fy), "N"},
          {"gamma_m gamma_SC", "resistance factors", section.factor, "1"}};
}

/// The station where the formula does not hold, nearest to its end; null where it holds all along.
const CheckStation* where_load_does_not_hold(const CheckStations& all, CheckRegion region) {
  const CheckStation* at = most_used(all, region, [&](const CheckStation& station) {
    const LoadCapacity& capacity = all.section_of(station).load;
    return capacity.slender_enough ? station.largest_force / capacity.axial_limit : kLargestReserve;
  });
  return load_formula_holds(all.section_of(*at).load, at->largest_force) ? nullptr : at;
}

std::string why_load_does_not_hold(const CheckSection& section) {
  return section.load.slender_enough ? "valid for an effective force below 0.4 S_p" : "valid for 15 <= D/t2 <= 45";
}

CheckRow load_row(const CheckStations& all, CheckRegion region, const CheckSettings& settings) {
  CheckRow row = row_of(kLoad, region);
  row.governing = region != CheckRegion::overbend;
  const CheckStation* at = most_used(all, region, [](const CheckStation& station) { return station.load.value; });
  const CheckSection& section = all.section_of(*at);
  if (any_section(all, region, [](const CheckSection& s) { return !s.load.known; })) {
    return not_done(row, "tensile strength not given");
  }
  const LoadTerms terms =
      load_terms(section.load, at->design_moment, at->design_force, at->load_pressure, 0.0, at->share);
  place_row(row, *at);
  if (all.in_time) time_row(row, at->load.time);
  row.inputs = load_inputs(section, *at);
  row.demand = at->design_moment;
  row.capacity = std::max(0.0, std::sqrt(std::max(0.0, 1.0 - terms.pressure)) - terms.axial * terms.axial) * at->share /
                 section.load.moment_factor;
  row.utilisation = terms.utilisation();
  row.reserve = load_reserve(terms);
  row.sheet = dnv_load_sheet(all, *at, settings, terms);
  judge(row);
  if (!row.governing) row.remark = "the pipe conforms to the supports, the strain governs";
  if (const CheckStation* beyond = where_load_does_not_hold(all, region)) {
    outside(row, why_load_does_not_hold(all.section_of(*beyond)));
  }
  return row;
}

constexpr const char* kBendHolds = "valid for D/t2 < 45";

CheckRow bend_row(const CheckStations& all, const CheckSettings& settings) {
  CheckRow row = row_of(kBend, CheckRegion::overbend);
  const CheckStation* at =
      most_used(all, CheckRegion::overbend, [](const CheckStation& station) { return station.bend.value; });
  const CheckSection& section = all.section_of(*at);
  const double raised = internal_pressure_factor(-at->bend_pressure, section.strain.burst);
  place_row(row, *at);
  row.inputs = {{"eps_F", "functional (static) strain", at->strain, "1"},
                {"eps_Sd", "design strain", at->design_strain, "1"},
                {"SNCF", "strain factor of field joints", section.strain_factor, "1"},
                {"eps_c", "strain capacity", section.strain_capacity * raised, "1"},
                {"p_e - p_i", "external minus internal pressure", at->bend_pressure, "Pa"},
                {"p_c(t2)", "collapse pressure", section.collapse, "Pa"}};
  if (!section.strain.holds) {
    outside(row, kBendHolds);
    return row;
  }
  if (all.in_time) time_row(row, at->bend.time);
  const StrainTerms terms = strain_terms(section.strain, at->design_strain, at->bend_pressure, 0.0);
  row.demand = at->design_strain;
  row.utilisation = terms.utilisation();
  row.reserve = terms.reserve();
  row.sheet = dnv_strain_sheet(all, *at, settings, terms);
  row.capacity =
      raised * std::pow(std::max(0.0, 1.0 - terms.pressure), 1.0 / terms.exponent) / section.strain.strain_factor;
  judge(row);
  if (any_section(all, CheckRegion::overbend, [](const CheckSection& s) { return !s.strain.holds; })) {
    outside(row, kBendHolds);
  }
  return row;
}

}  // namespace

std::vector<CheckRow> dnv_rows(const CheckStations& all, const CheckSettings& settings) {
  std::vector<CheckRow> rows = {collapse_row(all, settings), propagation_row(all, settings)};
  if (settings.arrestor) rows.push_back(crossover_row(all, settings));
  for (const CheckRegion region : judged_regions(all)) {
    if (most_used(all, region, [](const CheckStation&) { return 0.0; }) == nullptr) continue;
    if (region == CheckRegion::overbend) rows.push_back(bend_row(all, settings));
    rows.push_back(load_row(all, region, settings));
  }
  return rows;
}

}  // namespace overbend
