#include "checks/check_section.h"

#include <algorithm>
#include <cmath>

#include "checks/dnv_strength.h"

namespace overbend {
namespace {

void find_strength(CheckSection& out, const SteelDescription& steel, const CheckSettings& settings) {
  out.smys = steel.yield_stress;
  if (steel.tensile_strength) {
    out.smts = *steel.tensile_strength;
  } else if (const std::optional<SteelGrade> grade = find_grade(steel.yield_stress)) {
    out.smts = grade->tensile_strength;
    out.grade_of_smts = grade->name;
  }
  out.fy = characteristic_strength(out.smys, settings.alpha_u);
  out.fu = characteristic_strength(out.smts, settings.alpha_u);
  out.stress_limit = kStressShare * (settings.yield_basis == YieldBasis::fy ? out.fy : out.smys);
}

void find_laying_limits(CheckSection& out, const CheckSettings& settings) {
  constexpr double kOwn = 2.5e6;  // difference between a grade's SMYS in MPa and rounded from ksi
  out.laying = settings.grade.empty() ? laying_limits(out.smys) : find_grade_limits(settings.grade);
  out.laying_exact = !settings.grade.empty() || (out.laying && std::abs(out.laying->yield_stress - out.smys) <= kOwn);
}

void find_dnv_capacities(CheckSection& out, const CheckSettings& settings) {
  Wall thinnest = out.wall;
  thinnest.thickness = out.thinnest;
  out.collapse_thinnest = collapse_pressure(thinnest, out.fy, out.alpha_fab, settings.ovality);
  out.collapse = collapse_pressure(out.wall, out.fy, out.alpha_fab, settings.ovality);
  out.propagation = propagation_pressure(out.wall, out.fy, out.alpha_fab);
  if (out.smts > 0.0) out.load = load_capacity(out.wall, out.fy, out.fu, out.collapse, out.factor);
  out.strain_capacity = strain_capacity(out.wall, settings.alpha_h, 0.0, 0.0);
  out.strain.holds = out.wall.slenderness() < 45.0 && out.strain_capacity > 0.0;
  if (out.strain.holds) out.strain.strain_factor = strain_safety_factor(settings.safety_class) / out.strain_capacity;
  out.strain.collapse_factor = out.factor / out.collapse;
  out.strain.burst = out.load.burst;
}

void find_api_factors(CheckSection& out, const CheckSettings& settings, Manufacture manufacture) {
  const bool expanded = manufacture == Manufacture::uoe || manufacture == Manufacture::uo;
  out.api = {out.wall.diameter, out.wall.thickness, out.smys, out.wall.youngs_modulus, out.wall.poissons_ratio};
  out.api_collapse_share = settings.api.collapse_factor.value_or(expanded ? 0.6 : 0.7);
  out.api_delta = settings.api.ovality.value_or(0.5 * settings.ovality);
  const double since_fourth = std::min(1.0, out.api_collapse_share / api_ovality_factor(out.api_delta));
  out.api_pressure_factor =
      settings.api.combined_collapse_factor.value_or(settings.api.edition == ApiEdition::third ? 1.0 : since_fourth);
}

}  // namespace

CheckSection make_check_section(const SectionDescription& section, const CheckSettings& settings) {
  const SteelDescription& steel = section.steel;
  const Manufacture manufacture = settings.manufacture.value_or(Manufacture::uoe);
  CheckSection out;
  out.wall = {steel.outside_diameter, steel.wall_thickness, steel.youngs_modulus, steel.poissons_ratio};
  out.thinnest = steel.wall_thickness - settings.wall_tolerance;
  out.alpha_fab = settings.alpha_fab.value_or(fabrication_factor(manufacture));
  out.factor = kMaterialResistance * safety_class_factor(settings.safety_class);
  out.strain_factor = section.joint && !section.coatings.empty() ? section.joint->strain_factor.value_or(1.0) : 1.0;
  find_strength(out, steel, settings);
  find_laying_limits(out, settings);
  find_dnv_capacities(out, settings);
  find_api_factors(out, settings, manufacture);
  return out;
}

std::vector<CheckSection> check_sections(const Model& model) {
  std::vector<CheckSection> sections;
  for (std::size_t i = 0; i < model.sections.size(); ++i) {
    sections.push_back(make_check_section(model.find_section_description(i), model.description.checks));
    sections.back().name = model.sections[i].name;
    sections.back().cable = model.sections[i].kind == SectionKind::cable;
  }
  return sections;
}

std::vector<LoadFactors> load_combinations(const CheckSettings& settings) {
  std::vector<LoadFactors> combinations = {local_check_factors(settings.condition_factor)};
  if (settings.system_effects) combinations.push_back(system_check_factors(settings.condition_factor));
  return combinations;
}

}  // namespace overbend
