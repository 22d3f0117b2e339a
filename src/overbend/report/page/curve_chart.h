/// A chart of a few curves.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/page/blocks.h"

namespace overbend {

enum class CurveLook { line, thin, marks };

struct ChartCurve {
  std::string name;                               ///< For the legend.
  std::vector<std::pair<double, double>> points;  ///< In the units of the axes.
  CurveLook look = CurveLook::line;               ///< `marks`: circles at the points, no line.
  std::optional<std::size_t> colour = {};         ///< Number of its colour; its own where not given.
  bool in_legend = true;
};

struct CurveChart {
  std::string across, up;  ///< What the axes are, with units.
  std::vector<ChartCurve> curves;
  std::vector<ChartCurve> ground;  ///< Thin lines that stand for what surrounds: bed, water level.
  std::vector<ChartCurve> water;   ///< The same in the colour of water.
};

Blocks curve_figure(const CurveChart& chart, const std::string& caption);

}  // namespace overbend
