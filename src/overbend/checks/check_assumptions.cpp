#include "checks/check_assumptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/shown_unit.h"
#include "model/description/description_enum_names.h"

namespace overbend {
namespace {

void assume_sources(Assumptions& list, const CheckSettings& settings) {
  if (settings.codes != CheckCodes::api) {
    list.push_back({AssumptionRank::governing,
                    "Code checks: the formulas of DNV-ST-F101 are compared with public restatements, as the "
                    "calculation sheet says line by line; parts of the load-controlled, displacement-controlled and "
                    "simplified laying criteria are recalled and could not be confirmed: the girth weld factor, the "
                    "table of laying strains and 0.87 f_y. Compare the sheet with the printed standard."});
  }
  if (settings.codes != CheckCodes::dnv) {
    list.push_back({AssumptionRank::governing,
                    "Code checks: the formulas of API RP 1111 are compared with public restatements, as the "
                    "calculation sheet says; the ovality factor g and the factor f_1 of API RP 1111 are recalled and "
                    "could not be confirmed. Compare the sheet with the printed standard."});
  }
}

/// Assumptions on the criteria for the parts of a laid pipe.
void assume_laying(Assumptions& list) {
  list.push_back(
      {AssumptionRank::governing,
       "Code checks: over the supports the pipe conforms to the stinger and is checked as displacement controlled; the "
       "load-controlled criterion is given there for information. Below the last support in contact, in the sagbend "
       "and on the seabed it is checked as load controlled. Regions are those of the static state."});
  list.push_back({AssumptionRank::other,
                  "Code checks: a Lueders plateau of the stress-strain curve and point loads, which the "
                  "displacement-controlled criterion of DNV-ST-F101 has treated since 2017, do not enter; of steel "
                  "with a plateau the strain capacity may be lower."});
}

void assume_dnv(Assumptions& list, const CheckStations& all, const CheckSettings& settings) {
  list.push_back({AssumptionRank::setting,
                  fmt::format("Code checks: installation, safety class {}; condition factor {:.4g}; no corrosion "
                              "allowance, fabrication tolerance of the wall {}, ovality {:.4g}.",
                              enum_name(settings.safety_class), settings.condition_factor,
                              shown_digits(settings.wall_tolerance, section_length(), 4), settings.ovality)});
  if (all.line.empty()) {
    assume_laying(list);
  } else {
    list.push_back({AssumptionRank::governing,
                    "Code checks: pipe of lines by themselves is checked as load controlled all along."});
  }
  const char* current = !all.current_separate ? "with its current" : "without its current";
  list.push_back(
      {AssumptionRank::governing,
       all.in_time
           ? fmt::format(
                 "Code checks over a run: the static state, {}, is the functional load effect; the dynamic part{} is "
                 "the environmental one. Factors 1.1 and 1.3, or 1/1.1 and 1/1.3 where favourable, whichever is worse; "
                 "the maximum of the run is reported, without extrapolation to three hours.",
                 current, all.current_separate ? ", together with the contribution of the steady current," : "")
           : fmt::format("Code checks: a static state, {}, counts as functional load effect (factor 1.1){}; load "
                         "effects of waves and motion need a dynamic analysis.",
                         current,
                         all.current_separate ? ", the contribution of the steady current as environmental (factor 1.3)"
                                              : "")});
  list.push_back({AssumptionRank::other,
                  settings.system_effects
                      ? "Code checks: system effects are normally present during installation: load combination a (1.2 "
                        "functional, 0.7 environmental) is checked in addition to b (checks.system_effects)."
                      : "Code checks: load combination a is omitted because checks.system_effects is false."});
  list.push_back({AssumptionRank::other,
                  fmt::format("Code checks: the limit 0.87 f_y of the equivalent stress uses {} (checks.yield_basis).",
                              settings.yield_basis == YieldBasis::fy
                                  ? fmt::format("f_y = alpha_U SMYS with alpha_U {:.4g}", settings.alpha_u)
                                  : "f_y = SMYS, without alpha_U")});
  list.push_back({AssumptionRank::other,
                  "Code checks: the equivalent stress is the von Mises stress of this report (Lame at both walls), "
                  "without load factors."});
}

void assume_material(Assumptions& list, const CheckStations& all, const CheckSettings& settings) {
  if (!settings.manufacture && !settings.alpha_fab) {
    list.push_back({AssumptionRank::governing,
                    "Code checks: the manufacture of the pipe is not given; UOE, the least favourable, is assumed, "
                    "with the fabrication factor 0.85 and, for API, the collapse factor 0.6."});
  }
  for (std::size_t i = 0; i < all.sections.size(); ++i) {
    const CheckSection& section = all.sections[i];
    if (section.cable) continue;
    const std::string where = i == 0 && all.line.empty() ? "" : fmt::format(" of '{}'", section.name);
    if (!section.grade_of_smts.empty()) {
      list.push_back(
          {AssumptionRank::governing,
           fmt::format(
               "Code checks: the tensile strength{} is not given; {} of API 5L {} with this yield stress is used.",
               where, shown(section.smts, "Pa", 0), section.grade_of_smts)});
    } else if (section.smts <= 0.0) {
      list.push_back(
          {AssumptionRank::governing, fmt::format("Code checks: the tensile strength{} is not given and no grade of "
                                                  "API 5L has this yield stress: checks that need it are not made.",
                                                  where)});
    }
  }
}

void assume_api(Assumptions& list, const CheckStations& all, const CheckSettings& settings) {
  const CheckSection& section = all.sections.front();
  list.push_back(
      {AssumptionRank::setting,
       fmt::format("Code checks: API RP 1111, {} edition, with f_o {:.4g}, f_c {:.4g}, f_1 {:.4g} and delta {:.4g}; "
                   "the installation strain is the maximum longitudinal strain, including its axial part.",
                   std::array{"3rd", "4th", "5th"}[static_cast<std::size_t>(settings.api.edition)],
                   section.api_collapse_share, section.api_pressure_factor, settings.api.bending_factor,
                   section.api_delta)});
}

}  // namespace

Assumptions check_assumptions(const CheckStations& all, const CheckSettings& settings) {
  Assumptions list;
  if (all.sections.empty()) return list;
  if (std::any_of(all.sections.begin(), all.sections.end(), [](const CheckSection& s) { return s.cable; })) {
    list.push_back(
        {AssumptionRank::other,
         "Code checks: the codes are applied to pipe and head; the cable is held to its breaking load only."});
  }
  assume_sources(list, settings);
  if (settings.codes != CheckCodes::api) assume_dnv(list, all, settings);
  assume_material(list, all, settings);
  if (settings.codes != CheckCodes::dnv) assume_api(list, all, settings);
  if (settings.point_load) {
    list.push_back({AssumptionRank::other,
                    "Code checks: the force of a roller reduces the plastic moment at its station by 1 - (D/t2)/130 "
                    "R/R_y; recalled, not compared with the printed standard."});
  }
  return list;
}

}  // namespace overbend
