/// The mooring lines of a lay as lines of its system: elements with mass, drag and the bed's friction.
#pragma once

#include "moorings/spread.h"
#include "system/system.h"

namespace overbend {

/// Shapes to start from, six unknowns per node, line by line.
using LineShapes = std::vector<std::vector<double>>;

/// Adds the lines of `spread`, with the lengths they have there, behind those of `system`: from their anchors on the
/// bed to their fairleads on body 0, which lies in the model's mean pose. Parted ones are left out. Returns elastic
/// catenaries for first shapes. Lines point into `model`, which must outlive them.
LineShapes add_mooring_lines(const Model& model, const MooringSpread& spread, System& system);

/// Names of the lines that are there, in the order of the system.
std::vector<std::string> mooring_names(const MooringSpread& spread);

}  // namespace overbend
