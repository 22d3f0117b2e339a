/// Curves of results, overlaid in figures.
#pragma once

#include <string>
#include <vector>

#include "results/dynamic_results.h"
#include "results/folder_comparison.h"

namespace overbend {

/// A curve and the figure that it belongs to.
struct FolderCurve {
  std::string title, x_label, y_label;
  std::vector<double> x, y;
};
using FolderCurves = std::vector<FolderCurve>;

/// Adds shape, tension, moment and stress of the static line.
void add_curves(FolderCurves& curves, const StaticResults& results);

/// Adds envelopes of tension, moment and stress, and histories of tension and stress.
void add_curves(FolderCurves& curves, const StaticResults& statics, const DynamicResults& results);

/// Returns one figure for the curves of each title; figures with the curves of only one folder are left out.
std::vector<OverlaidFigure> overlaid(const std::vector<FolderCurves>& folders);

}  // namespace overbend
