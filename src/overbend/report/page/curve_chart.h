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
  std::string name;                               ///< Legend text.
  std::vector<std::pair<double, double>> points;  ///< In the units of the axes.
  CurveLook look = CurveLook::line;               ///< `marks`: circles at the points without a line.
  std::optional<std::size_t> colour = {};         ///< Number of its colour; by default its own.
  bool in_legend = true;
};

struct CurveChart {
  std::string across, up;  ///< Labels of the axes with units.
  std::vector<ChartCurve> curves;
  std::vector<ChartCurve> ground;  ///< Thin lines of the surroundings: seabed.
  std::vector<ChartCurve> water;   ///< The same in the colour of water.
};

/// Returns a figure with the chart.
Blocks curve_figure(const CurveChart& chart, const std::string& caption);

}  // namespace overbend
