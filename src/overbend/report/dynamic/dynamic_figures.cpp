#include <set>

#include "report/dynamic/history_data.h"
#include "report/page/figure_list.h"
#include "report/page/figures.h"

namespace overbend {
namespace {

std::vector<Figure> all_figures(bool pipe) {
  return {
      {"envelope_mises",
       "Dynamic von Mises stress: range over time (band), mean and static value",
       {"whole", "overbend"}},
      {"envelope_tension",
       "Dynamic effective tension: range over time (band), mean and static value",
       {"whole", "overbend"}},
      {"envelope_moment",
       "Dynamic bending moment: range over time (band), mean and static value",
       {"whole", "overbend"}},
      {"envelope_strain",
       "Dynamic longitudinal strain: range over time (band), mean and static value",
       {"whole", "overbend"}},
      {"history",
       "Time history of tension; the build-up is shaded. Values refer to all time steps, curves to the output steps",
       {"tension"}},
      {"history",
       "Time history of the tensioner, operational range shaded; travel is positive when paid out",
       {"tensioner"}},
      {"history", "Time history of maximum von Mises stress in overbend and sagbend", {"stress"}},
      {"history", "Time histories of the largest support reactions", {"reactions"}},
      {"history",
       "Time history of the clearance at the stinger tip; below zero the pipe is in contact",
       {"separation"}},
      {"history",
       "Time history of the stinger on its hinges: angle from the nominal position, positive for tip down, and "
       "draught of its tanks",
       {"stinger_angle"}},
      {"history",
       "Time history of the hinges of the stinger: forces on the section, moment of the stops",
       {"stinger_hinge"}},
      {"history",
       pipe ? "Time histories of the pull-ahead: vessel, tensioner and pipe"
            : "Time history of the pull-ahead: vessel offset from the nominal pose; the build-up is shaded",
       {"operation"}},
      {"history",
       pipe ? "Time history of wave elevation at the stern shoe" : "Time history of wave elevation at midship",
       {"wave"}},
      {"history",
       pipe ? "Time histories of vessel motion" : "Time histories of vessel motion; the build-up is shaded",
       {"motions"},
       true},
      {"spectra", "Spectra of motions and loads; the upper scale is the period", {"all"}, true},
      {"ranges", "Reactions of the rollers over time, per row: range, mean and static value", {"bars"}},
      {"shares", "Fraction of time in contact, per row; \u00d7 marks a roller that the pipe never touches", {"bars"}},
      {"impacts", "Hardest impacts between pipe and rollers", {"time", "velocity"}},
  };
}

}  // namespace

Blocks dynamic_figures_section(const StaticResults& statics, const DynamicResults& results) {
  std::set<std::string> groups;
  for (const Json& history : history_data(statics, results)) {
    groups.insert(history["group"].get<std::string>());
  }
  const bool supported = !results.supports.empty();
  const auto is_applicable = [&](const Figure& figure, const std::string& part) {
    if (figure.id == "history") return groups.contains(part);
    if (figure.id == "spectra") return !spectrum_data(results).empty();
    if (figure.id == "impacts") return !results.hardest_impacts.empty();
    return supported || (part == "whole" && statics.has_pipe());
  };
  return block::section("dynamic-figures", "Figures of the dynamic analysis",
                        figure_list(all_figures(statics.has_pipe()), is_applicable));
}

}  // namespace overbend
