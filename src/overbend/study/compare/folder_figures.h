/// Curves of results that are laid over each other.
#pragma once

#include <string>
#include <vector>

#include "results/dynamic_results.h"
#include "results/folder_comparison.h"

namespace overbend {

/// A curve by the figure that it belongs to.
struct FolderCurve {
  std::string title, x_label, y_label;
  std::vector<double> x, y;
};
using FolderCurves = std::vector<FolderCurve>;

/// Shape, tension, moment and stress of the static line.
void add_curves(FolderCurves& curves, const StaticResults& results);

/// Envelopes of tension, moment and stress, and histories of tension and stress.
void add_curves(FolderCurves& curves, const StaticResults& statics, const DynamicResults& results);

/// Curves of one title in one figure; figures that only one of the folders has are left out.
std::vector<OverlaidFigure> overlaid(const std::vector<FolderCurves>& folders);

}  // namespace overbend
