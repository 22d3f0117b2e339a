/// The formulas of the code checks compared with values computed independently.
#include "checks/dnv_combined.h"
#include "checks/dnv_strain.h"
#include "checks/test_pipes.h"
#include "groups.h"

namespace overbend::validation {
namespace {

constexpr const char* kBasis = "computed independently; digits printed";
constexpr double kDelta = 0.005;   ///< Ovality by API.
constexpr double kStrain = 0.002;  ///< Strain of the displacement-controlled check.

void add_pressures(std::vector<Row>& rows, const TestPipe& p, double collapse) {
  const auto add = [&](const char* name, const char* unit, double ours, double reference, double digits) {
    rows.push_back({p.name, name, unit, ours, reference, 0.5 * digits, kBasis});
  };
  const double propagation = propagation_pressure(p.geometry(), p.fy(), p.alpha_fab);
  add("elastic collapse p_el", "MPa", 1e-6 * elastic_collapse_pressure(p.geometry()), p.elastic, 1e-4);
  add("plastic collapse p_p", "MPa", 1e-6 * plastic_collapse_pressure(p.geometry(), p.fy(), p.alpha_fab), p.plastic,
      1e-4);
  add("collapse p_c", "MPa", 1e-6 * collapse, p.collapse, 1e-4);
  add("collapse, utilisation", "", p.pressure() * kGammas / collapse, p.collapse_share, 1e-5);
  add("propagation p_pr", "MPa", 1e-6 * propagation, p.propagation, 1e-4);
  add("propagation, utilisation", "", p.pressure() * kGammas / propagation, p.propagation_share, 1e-5);
}

void add_buckling(std::vector<Row>& rows, const TestPipe& p, double collapse) {
  const auto add = [&](const char* name, const char* unit, double ours, double reference, double digits) {
    rows.push_back({p.name, name, unit, ours, reference, 0.5 * digits, kBasis});
  };
  const Wall wall = p.geometry();
  const LoadCapacity load = load_capacity(wall, p.fy(), p.fu(), collapse, kGammas);
  const double strain = strain_capacity(wall, 0.93, 0.0, 0.0);
  const StrainCapacity bend{2.0 / strain, kGammas / collapse, 0.0, true};
  add("alpha_c", "", load.alpha_c, p.alpha_c, 1e-5);
  add("plastic axial force S_p", "kN", 1e-3 * plastic_axial_force(wall, p.fy()), p.plastic_force, 1e-2);
  add("plastic moment M_p", "kN m", 1e-3 * plastic_moment(wall, p.fy()), p.plastic_moment, 1e-3);
  add("load controlled, utilisation", "",
      load_terms(load, 1e3 * p.moment, 1e3 * p.force, p.pressure(), 0.0).utilisation(), p.lcc, 1e-5);
  add("strain capacity eps_c", "", strain, p.strain_capacity, 1e-5);
  add("displacement controlled at 0.2 %, utilisation", "", strain_terms(bend, kStrain, p.pressure(), 0.0).utilisation(),
      p.dcc, 1e-5);
}

void add_api(std::vector<Row>& rows, const TestPipe& p) {
  const auto add = [&](const char* name, const char* unit, double ours, double reference, double digits) {
    rows.push_back({p.name, name, unit, ours, reference, 0.5 * digits, kBasis});
  };
  const ApiPipe pipe = p.api();
  const double strain = 3.33 * 0.0015, fourth = 0.6 / api_ovality_factor(kDelta);
  add("API collapse P_c", "MPa", 1e-6 * api_collapse_pressure(pipe), p.api_collapse, 1e-4);
  add("API propagation P_p", "MPa", 1e-6 * api_propagation_pressure(pipe), p.api_propagation, 1e-4);
  add("API bending and pressure, 3rd edition", "", api_bending_utilisation(pipe, strain, p.pressure(), 1.0, kDelta),
      p.api_bending_third, 1e-5);
  add("API bending and pressure, 4th edition", "", api_bending_utilisation(pipe, strain, p.pressure(), fourth, kDelta),
      p.api_bending_fourth, 1e-5);
}

}  // namespace

Group code_checks() {
  Group group{
      "Code formulas",
      "formulas computed independently",
      "The formulas of the [code checks](theory/checks.md) for three pipes: alpha_U 0.96, low safety class, O_0 "
      "0.005, alpha_h 0.93, load factors 1, water of 1025 kg/m3. The references were computed independently from the "
      "same formulas: they verify the implementation, not the agreement of the formulas with the standards, which has "
      "not been checked.",
      {}};
  Table table{"DNV-ST-F101 and API RP 1111", "16 in X60 in 89 m, 24 in X65 in 1000 m, 12.75 in X65 in 2000 m.", {}};
  for (const TestPipe& p : kTestPipes) {
    const double collapse = collapse_pressure(p.geometry(), p.fy(), p.alpha_fab, 0.005);
    add_pressures(table.rows, p, collapse);
    add_buckling(table.rows, p, collapse);
    add_api(table.rows, p);
  }
  group.tables.push_back(table);
  return group;
}

}  // namespace overbend::validation
