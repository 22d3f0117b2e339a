/// A chart of a few curves as an SVG that needs no script.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace overbend {

struct ChartCurve {
  std::string name;                               ///< Plain text, for the legend.
  std::vector<std::pair<double, double>> points;  ///< In the units of the axes.
};

struct CurveChart {
  std::string id;          ///< Of the figure, for links.
  std::string across, up;  ///< Plain text: what the axes are, with units.
  std::vector<ChartCurve> curves;
  std::vector<ChartCurve> ground;  ///< Thin lines that stand for what surrounds: bed, water level.
};

/// HTML of a figure. `caption` is plain text.
std::string curve_figure(const CurveChart& chart, const std::string& caption);

}  // namespace overbend
