/// Where the line lies on the bed, and where it spans.
#pragma once

#include <vector>

#include "statics/equations/touchdown.h"

namespace overbend {

/// A stretch in contact; `from` is its end nearer the tensioner.
struct BedContact {
  ElementPlace from, to;
};

/// Whether the line may span behind its touchdown: on a shaped bed, or where something is fixed to it.
bool may_span(const Model& model);

/// All of them from the tensioner down; the last may end at the far end.
std::vector<BedContact> bed_contacts(const StaticSystem& system, const LineState& state);

/// Where contact with the bed begins and ends of a line that may span; none of others, where touchdown says all.
std::vector<ElementPlace> contact_places(const StaticSystem& system, const LineState& state);

/// Their ends as the mesh wants to know them: short stretches by distance from the tensioner.
std::vector<LineStretch> contact_edges(const StaticSystem& system, const std::vector<BedContact>& contacts);

}  // namespace overbend
