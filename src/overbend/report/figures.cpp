#include "report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/html.h"
#include "report/places.h"

namespace overbend {
namespace {

/// `id` chooses what is drawn; `parts` are the panels below one caption.
struct Figure {
  const char* id;
  const char* caption;
  bool needs_supports;
  std::vector<const char*> parts;
};

const std::vector<Figure>& all_figures() {
  static const std::vector<Figure> kFigures = {
      {"configuration", "Configuration in three dimensions", false, {"whole", "overbend", "stinger"}},
      {"stinger",
       "Ramp and stinger seen from port, true to scale; side rollers in outline",
       true,
       {"overbend", "stinger", "tip"}},
      {"geometry", "Geometry", false, {"whole", "overbend", "plan"}},
      {"tension", "Effective tension and wall tension", false, {"whole", "overbend"}},
      {"moment", "Bending moment", false, {"whole", "overbend"}},
      {"bending", "Bending stress", false, {"whole", "overbend"}},
      {"mises", "von Mises stress", false, {"whole", "overbend"}},
      {"strain", "Longitudinal strain, largest over the section", false, {"whole", "overbend"}},
      {"reactions", "Reactions of the rollers, row by row", true, {"bars"}},
      {"separations", "Separation of pipe and rollers, row by row", true, {"bars"}},
  };
  return kFigures;
}

/// Whether the line leaves the vertical plane by more than a plan would show as a stroke.
bool drifts(const StaticResults& results) {
  constexpr double kVisible = 0.05;  // [m]
  return std::any_of(results.stations.begin(), results.stations.end(),
                     [&](const Station& at) { return std::abs(ship_point(results, at.p_W).y()) > kVisible; });
}

/// Whether there is something to show in this panel.
bool makes_sense(const std::string& part, const StaticResults& results) {
  if (part == "whole") {
    return true;
  }
  if (part == "plan") {
    return drifts(results);
  }
  const bool stinger = std::any_of(results.supports.begin(), results.supports.end(),
                                   [](const SupportResult& box) { return box.stinger; });
  return part == "stinger" ? stinger : !results.supports.empty();
}

}  // namespace

std::string figures_section(const StaticResults& results) {
  std::string body;
  int number = 0;
  for (const Figure& figure : all_figures()) {
    if (figure.needs_supports && results.supports.empty()) {
      continue;
    }
    body += fmt::format("<figure id=\"fig-{}\">\n", figure.id);
    for (const char* part : figure.parts) {
      if (!makes_sense(part, results)) {
        continue;
      }
      body += fmt::format("<div class=\"panel\" data-figure=\"{}\" data-part=\"{}\"></div>\n", figure.id, part);
    }
    body += fmt::format("<figcaption>Figure {}. {}</figcaption>\n</figure>\n", ++number, html::escape(figure.caption));
  }
  return html::section(
      "figures", "Figures",
      "<noscript><p>The figures are drawn by scripts, which this browser does not run. The tables below "
      "hold the same results.</p></noscript>\n" +
          body);
}

}  // namespace overbend
