#include "checks/design_effect_lines.h"

#include <cmath>

namespace overbend {
namespace {

constexpr const char* kFactors = "table 4-4";
constexpr const char* kStatic = "static state";
constexpr const char* kOfRun = "run: table 4-4, combinations a and b, evaluated at every step";
constexpr const char* kFunctional = "load effect factor, functional";
constexpr const char* kEnvironmental = "load effect factor, environmental";

/// Load factors of a functional and an environmental load effect, gamma_C in the first.
struct FactorPair {
  double functional = 0.0, environmental = 0.0;
};

/// Returns the pair with the maximum magnitude of gamma_F a + gamma_E b.
template <class Effect, class Size>
FactorPair governing_pair(const LoadFactors& f, const Effect& a, const Effect& b, Size size) {
  FactorPair worst;
  double max_value = -1.0;
  for (const double functional : {f.functional, f.functional_favourable}) {
    for (const double environmental : {f.environmental, f.environmental_favourable}) {
      const double value = size(Effect(functional * a + environmental * b));
      if (value <= max_value) continue;
      max_value = value;
      worst = {functional, environmental};
    }
  }
  return worst;
}

double vector_size(const Vec3& v) {
  return v.norm();
}
double scalar_size(double v) {
  return std::abs(v);
}

void add_functional_factor(CalculationSheet& sheet, const char* symbol, double value) {
  sheet.computed({symbol, kFunctional, "", "1", kFactors, Confirmation::one_source, kDnvCombined}, value);
}

/// No public text restates the factor of a favourable environmental load effect.
void add_environmental_factor(CalculationSheet& sheet, const char* symbol, double value) {
  const bool favourable = value == local_check_factors(1.0).environmental_favourable;
  sheet.computed({symbol, kEnvironmental, "", "1", kFactors,
                  favourable ? Confirmation::unconfirmed : Confirmation::one_source, favourable ? "" : kDnvCombined},
                 value);
}

void add_condition(CalculationSheet& sheet, const CheckSettings& settings) {
  sheet.given("gamma_C", "condition load effect factor", settings.condition_factor, "1", "checks.condition_factor");
}

/// Symbols of the components of a load effect: functional and environmental, vertical and lateral.
struct ComponentNames {
  const char *functional[2], *environmental[2];
  const char *meaning_functional, *meaning_environmental, *units;
};

void add_components(CalculationSheet& sheet, const ComponentNames& names, const Vec3& functional, const Vec3& current) {
  for (int axis = 0; axis < 2; ++axis) {
    sheet.given(names.functional[axis], names.meaning_functional, functional(axis), names.units, kStatic);
    sheet.given(names.environmental[axis], names.meaning_environmental, current(axis), names.units, kStatic);
  }
}

void add_design_moment(CalculationSheet& sheet, const CheckStation& station, const CheckSettings& settings) {
  const FactoredEffects& e = station.effects;
  const FactorPair pair = governing_pair(e.load_factors, e.functional, e.current, vector_size);
  add_functional_factor(sheet, "gamma_F", pair.functional / settings.condition_factor);
  if (e.current.isZero(0.0)) {
    sheet.given("M_F", "functional bending moment", station.moment, "N m", kStatic);
    sheet.computed({"M_Sd", "design bending moment", "gamma_F gamma_C M_F", "N m", kFactors, Confirmation::one_source,
                    kDnvCombined},
                   station.design_moment);
    return;
  }
  add_environmental_factor(sheet, "gamma_E", pair.environmental);
  add_components(sheet,
                 {{"M_Fv", "M_Fh"},
                  {"M_Ev", "M_Eh"},
                  "functional bending moment, v in the vertical plane of the pipe, h out of it",
                  "environmental bending moment, of the current",
                  "N m"},
                 e.functional, e.current);
  sheet.computed({"M_Sd", "design bending moment",
                  "sqrt((gamma_F gamma_C M_Fv + gamma_E M_Ev)^2 + (gamma_F gamma_C M_Fh + gamma_E M_Eh)^2)", "N m",
                  kFactors, Confirmation::one_source, kDnvCombined},
                 station.design_moment);
}

void add_design_force(CalculationSheet& sheet, const CheckStation& station, const CheckSettings& settings) {
  const FactoredEffects& e = station.effects;
  const FactorPair pair = governing_pair(e.load_factors, station.force, e.tension, scalar_size);
  add_functional_factor(sheet, "gamma_FS", pair.functional / settings.condition_factor);
  add_environmental_factor(sheet, "gamma_ES", pair.environmental);
  sheet.given("S_F", "functional effective axial force", station.force, "N", kStatic);
  sheet.given("S_E", "environmental effective axial force, of the current", e.tension, "N", kStatic);
  sheet.computed({"S_Sd", "design effective axial force", "gamma_FS gamma_C S_F + gamma_ES S_E", "N", kFactors,
                  Confirmation::one_source, kDnvCombined},
                 station.design_force);
}

}  // namespace

void add_design_loads(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                      const CheckSettings& settings) {
  if (all.in_time) {
    sheet.given("M_Sd", "design bending moment at the governing instant", station.design_moment, "N m", kOfRun);
    sheet.given("S_Sd", "design effective axial force at the governing instant", station.design_force, "N", kOfRun);
    return;
  }
  add_condition(sheet, settings);
  add_design_moment(sheet, station, settings);
  add_design_force(sheet, station, settings);
}

void add_design_strain(CalculationSheet& sheet, const CheckStations& all, const CheckStation& station,
                       const CheckSettings& settings) {
  if (all.in_time) {
    sheet.given("eps_Sd", "design strain at the governing instant, strain factor of field joints included",
                station.design_strain, "1", kOfRun);
    return;
  }
  const FactoredEffects& e = station.effects;
  const FactorPair pair = governing_pair(e.strain_factors, e.functional_strain, e.current_strain, vector_size);
  add_condition(sheet, settings);
  sheet.given("SNCF", "strain concentration factor of field joints", all.section_for(station).strain_factor, "1",
              "pipe.joint.strain_factor");
  add_functional_factor(sheet, "gamma_F", pair.functional / settings.condition_factor);
  if (e.current_strain.isZero(0.0)) {
    sheet.given("eps_F", "functional strain, the largest longitudinal one", e.functional_strain.norm(), "1", kStatic);
    sheet.computed({"eps_Sd", "design strain", "SNCF gamma_F gamma_C eps_F", "1", kFactors, Confirmation::one_source,
                    kDnvCombined},
                   station.design_strain);
    return;
  }
  add_environmental_factor(sheet, "gamma_E", pair.environmental);
  add_components(sheet,
                 {{"eps_Fv", "eps_Fh"},
                  {"eps_Ev", "eps_Eh"},
                  "functional strain along the moment, v in the vertical plane of the pipe, h out of it",
                  "environmental strain, of the bending moment of the current",
                  "1"},
                 e.functional_strain, e.current_strain);
  sheet.computed(
      {"eps_Sd", "design strain",
       "SNCF sqrt((gamma_F gamma_C eps_Fv + gamma_E eps_Ev)^2 + (gamma_F gamma_C eps_Fh + gamma_E eps_Eh)^2)", "1",
       kFactors, Confirmation::one_source, kDnvCombined},
      station.design_strain);
}

}  // namespace overbend
