#include <set>

#include "report/figure_list.h"
#include "report/figures.h"
#include "report/history_data.h"

namespace overbend {
namespace {

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
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
       "Tension in time; the build-up is shaded. Numbers are of every step, curves of the rows of the histories",
       {"tension"}},
      {"history",
       "The tensioner in time, its operational range shaded; travel counts what was paid out",
       {"tensioner"}},
      {"history", "Largest von Mises stress of overbend and sagbend in time", {"stress"}},
      {"history", "Reactions of the supports pressed hardest in time", {"reactions"}},
      {"history", "Separation of pipe and stinger tip in time; below zero the pipe is in contact", {"separation"}},
      {"history", "Wave elevation at the stern shoe in time", {"wave"}},
      {"history", "Motions of the vessel in time", {"motions"}, true},
      {"spectra", "Spectra of what moves; the scale on top is the period", {"all"}, true},
      {"ranges", "Reactions of the rollers over time, row by row: range, mean and static value", {"bars"}},
      {"shares", "Share of time in contact, row by row; \u00d7 marks a roller that the pipe never touches", {"bars"}},
      {"impacts", "The hardest impacts of pipe and rollers", {"time", "velocity"}},
  };
  return kFigures;
}

}  // namespace

std::string dynamic_figures_section(const StaticResults& statics, const DynamicResults& results, int& number) {
  std::set<std::string> groups;
  for (const nlohmann::json& history : history_data(statics, results)) {
    groups.insert(history["group"].get<std::string>());
  }
  const bool supported = !results.supports.empty();
  const auto makes_sense = [&](const Figure& figure, const std::string& part) {
    const std::string id = figure.id;
    if (id == "history") return groups.count(part) != 0;
    if (id == "spectra") return !spectrum_data(results).empty();
    if (id == "impacts") return !results.hardest_impacts.empty();
    return part == "whole" || supported;
  };
  return figure_section("dynamic-figures", "Figures of the dynamic analysis",
                        figure_list(all_figures(), makes_sense, number));
}

}  // namespace overbend
