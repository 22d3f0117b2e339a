#include "model/material_description.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/shown_unit.h"

namespace overbend {
namespace {

std::string moment_form(const SteelDescription& steel) {
  const MaterialDescription& material = steel.material;
  if (material.moment_coefficient && material.moment_exponent) {
    return fmt::format("kappa/kappa_y = M/M_y + {:.4g} (M/M_y)^{:.4g}", *material.moment_coefficient,
                       *material.moment_exponent);
  }
  const MomentRambergOsgood fit = fit_moment_law(steel);
  return fmt::format(
      "kappa/kappa_y = M/M_y + {:.4g} (M/M_y)^{:.4g}, fitted to the stress-strain law integrated over the wall, from "
      "first yield to four times its curvature, moment within {:.2f} %",
      fit.coefficient, fit.exponent, 100.0 * fit.max_error);
}

std::string fit_label(const Section& section) {
  return section.bending
             ? fmt::format("; its moment curve is reproduced within {:.2f} %", 100.0 * section.bending->fit_error)
             : "";
}

}  // namespace

std::string material_law_label(const SteelDescription& steel) {
  const MaterialDescription& material = steel.material;
  const std::string yield = shown_digits(steel.yield_stress, "Pa", 4);
  switch (material.law) {
    case MaterialLaw::linear:
      return "linear elastic";
    case MaterialLaw::moment_ramberg_osgood:
      return moment_form(steel);
    case MaterialLaw::ramberg_osgood:
      return fmt::format("Ramberg-Osgood, n = {:.4g}, total strain {:.4g} % at {}",
                         material.hardening_exponent.value_or(0.0), 100.0 * material.yield_strain, yield);
    case MaterialLaw::bilinear:
      return fmt::format("bilinear, yield at {}, slope {} beyond yield", yield,
                         shown_digits(material.hardening_modulus, modulus_unit(), 4));
    case MaterialLaw::stress_strain:
      return fmt::format("stress-strain curve of {} points", material.stress_strain.size());
    case MaterialLaw::moment_curvature:
      return fmt::format("moment-curvature curve of {} points", material.moment_curvature.size());
  }
  return "";
}

Assumptions material_assumptions(const Model& model) {
  Assumptions list;
  for (std::size_t i = 0; i < model.sections.size(); ++i) {
    const SteelDescription& steel = model.find_section_description(i).steel;
    const bool linear = steel.material.law == MaterialLaw::linear;
    list.push_back({linear ? AssumptionRank::governing : AssumptionRank::setting,
                    fmt::format("Steel of section '{}': {}{}.", model.sections[i].name, material_law_label(steel),
                                fit_label(model.sections[i]))});
  }
  const auto& sections = model.sections;
  if (std::none_of(sections.begin(), sections.end(), [](const Section& s) { return s.bending.has_value(); })) {
    return list;
  }
  list.push_back({AssumptionRank::other,
                  "Steel that has yielded unloads elastically and hardens kinematically, fibre by fibre around the "
                  "wall; axially the pipe stays elastic."});
  if (std::any_of(sections.begin(), sections.end(), [](const Section& s) { return s.bending && s.bending->steel; })) {
    list.push_back({AssumptionRank::other,
                    "Moments come from the stress-strain law integrated over the wall, with the static wall tension "
                    "and hoop stress of the suspended pipe at each elevation; their variation in waves is neglected."});
    list.push_back(
        {AssumptionRank::other,
         "Stress of yielded steel is the elastic stress of the moment, limited to the value of the stress-strain curve "
         "at the maximum curvature so far; residual stresses in the wall are not tracked."});
  } else {
    list.push_back({AssumptionRank::other,
                    "For steel given by a moment curve, stress is the elastic stress of the moment, M D / (2 I)."});
  }
  list.push_back({AssumptionRank::governing,
                  model.description.statics.history == LayHistory::laying
                      ? "In statics every section has passed the supports from the tensioner and retains its plastic "
                        "curvature; it does not roll, although pipe with residual curvature tends to."
                      : "In statics every section is bent directly to its final shape, without the loading history "
                        "over the supports."});
  return list;
}

Findings material_findings(const Model& model) {
  constexpr double kMaxFitError = 0.02;
  Findings list;
  for (const Section& section : model.sections) {
    if (!section.bending || section.bending->fit_error <= kMaxFitError) continue;
    list.push_back(Finding{
        FindingCode::moment_curvature_fit,
        fmt::format(
            "the moment-curvature curve of section '{}' is reproduced only within {:.1f} %, and moments have the same "
            "uncertainty: give more points where the curve bends, or another law (pipe.steel.material)",
            section.name, 100.0 * section.bending->fit_error)}
                       .on(section.name)
                       .with("error", section.bending->fit_error, "1"));
  }
  return list;
}

}  // namespace overbend
