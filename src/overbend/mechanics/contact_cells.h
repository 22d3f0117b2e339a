/// Broad-phase search for roller contacts: one cell around all supports, inside it one cell per roller box, [silva2009]
/// figures 6 and 7. Cells are fixed in the ramp/stinger frame S and move with the vessel.
///
/// A cell is bounded along the vessel and above the rollers. It is open below and to the sides: a roller holds the pipe
/// on its desired side, so a pipe on the wrong side must be found. Along the vessel it contains every closest point
/// whose distance to the roller's axis is less than both radii plus kWrongSideReach. An element outside all cells costs
/// two comparisons.
#pragma once

#include <vector>

#include "model/vessel/supports.h"

namespace overbend {

inline constexpr double kWrongSideReach = 1.0;  ///< Guaranteed search distance on the wrong side of a roller [m].

struct Cell {
  double x_low = 0.0, x_high = 0.0, z_high = 0.0;  ///< Frame S [m].

  bool meets(double element_x_low, double element_x_high, double element_z_low) const {
    return element_x_high >= x_low && element_x_low <= x_high && element_z_low <= z_high;
  }
};

struct ContactCells {
  Cell all;
  std::vector<Cell> boxes;
};

/// Returns the cells of all supports. `pipe_radius`: maximum outer radius of the line [m].
ContactCells contact_cells(const Supports& supports, double pipe_radius);

/// Bounds of one element in S. The convex hull of the four Bezier points of the cubic contains the element.
struct ElementBounds {
  double x_low, x_high, z_low;
};

/// Elements [first, last) that may touch the rollers of a box; empty when first >= last.
struct ElementRange {
  int first = 0, last = 0;
};

/// Finds for every box the range of elements whose bounds intersect its cell. `ranges` is overwritten; no allocation
/// once it has its size.
void search_cells(const ContactCells& cells, const std::vector<ElementBounds>& elements,
                  std::vector<ElementRange>& ranges);

}  // namespace overbend
