#include "report/page/figures.h"

#include <algorithm>
#include <cmath>

#include "report/page/figure_list.h"
#include "results/fields/location_names.h"

namespace overbend {
namespace {

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"configuration", "Configuration in three dimensions", {"whole", "overbend", "stinger"}},
      {"stinger",
       "Ramp and stinger seen from port, true to scale; side rollers in outline",
       {"overbend", "stinger", "tip"}},
      {"geometry", "Geometry", {"whole", "overbend", "plan"}},
      {"tension", "Effective tension and wall tension", {"whole", "overbend"}},
      {"moment", "Bending moment", {"whole", "overbend"}},
      {"bending", "Bending stress", {"whole", "overbend"}},
      {"mises", "von Mises stress", {"whole", "overbend"}},
      {"strain", "Longitudinal strain, maximum over the section", {"whole", "overbend"}},
      {"reactions", "Reactions of the rollers, per row", {"bars"}},
      {"separations", "Separation between pipe and rollers, per row", {"bars"}},
  };
  return kFigures;
}

/// True if the line leaves the vertical plane by a distance visible in a plan.
bool leaves_vertical_plane(const StaticResults& results) {
  constexpr double kVisible = 0.05;  // [m]
  return std::any_of(results.stations.begin(), results.stations.end(),
                     [&](const Station& station) { return std::abs(ship_point(results, station.p_W).y()) > kVisible; });
}

/// True if the panel has content.
bool is_applicable(const std::string& part, const StaticResults& results) {
  if (part == "whole") {
    return true;
  }
  if (part == "plan") {
    return leaves_vertical_plane(results);
  }
  const bool stinger = std::any_of(results.supports.begin(), results.supports.end(),
                                   [](const SupportResult& box) { return box.stinger; });
  return part == "stinger" ? stinger : !results.supports.empty();
}

}  // namespace

Blocks figures_section(const StaticResults& results, const std::string& id, const std::string& heading) {
  if (!results.has_pipe()) return {};
  const auto shown = [&](const Figure&, const std::string& part) { return is_applicable(part, results); };
  return block::section(id, heading, figure_list(all_figures(), shown));
}

}  // namespace overbend
