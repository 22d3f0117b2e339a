#include "mechanics/contact_cells.h"

#include <algorithm>
#include <cmath>

#include "base/constants.h"

namespace overbend {
namespace {

Cell empty_cell() {
  return {kInfinity, -kInfinity, -kInfinity};
}

/// Extends a cell by a roller. The pipe can touch a roller only if its axis passes within both radii of the roller's
/// axis.
void enclose(Cell& cell, const Roller& roller, double pipe_radius) {
  const double reach = roller.radius + pipe_radius;
  const double half = 0.5 * roller.face;
  const double half_x = half * std::abs(roller.axis_S.x()) + reach + kWrongSideReach;
  const double half_z = half * std::abs(roller.axis_S.z()) + reach;
  cell.x_low = std::min(cell.x_low, roller.center_S.x() - half_x);
  cell.x_high = std::max(cell.x_high, roller.center_S.x() + half_x);
  cell.z_high = std::max(cell.z_high, roller.center_S.z() + half_z);
}

}  // namespace

ContactCells contact_cells(const Supports& supports, double pipe_radius) {
  ContactCells cells;
  cells.all = empty_cell();
  cells.boxes.assign(supports.boxes.size(), empty_cell());
  for (const Roller& roller : supports.rollers) {
    enclose(cells.boxes[static_cast<std::size_t>(roller.box)], roller, pipe_radius);
    enclose(cells.all, roller, pipe_radius);
  }
  return cells;
}

void search_cells(const ContactCells& cells, const std::vector<ElementBounds>& elements,
                  std::vector<ElementRange>& ranges) {
  ranges.assign(cells.boxes.size(), ElementRange{});
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const ElementBounds& bounds = elements[e];
    if (!cells.all.meets(bounds.x_low, bounds.x_high, bounds.z_low)) {
      continue;
    }
    for (std::size_t b = 0; b < cells.boxes.size(); ++b) {
      if (cells.boxes[b].meets(bounds.x_low, bounds.x_high, bounds.z_low)) {
        ElementRange& range = ranges[b];
        range.first = range.last == 0 ? static_cast<int>(e) : range.first;
        range.last = static_cast<int>(e) + 1;
      }
    }
  }
}

}  // namespace overbend
