/// Contacts of the line with the bed, and free spans between them.
#pragma once

#include <vector>

#include "statics/equations/touchdown.h"

namespace overbend {

/// Part of the line in contact with the bed; `from` is its end nearer the tensioner.
struct BedContact {
  ElementPlace from, to;
};

/// True if the line may span behind its touchdown point: on a shaped bed, or if structures are fixed to it.
bool may_span(const Model& model);

/// Returns all contacts from the tensioner down; the last may end at the far end.
std::vector<BedContact> bed_contacts(const StaticSystem& system, const LineState& state);

/// Returns the places where contact begins and ends on a line that may span; empty for other lines, which have only a
/// touchdown point.
std::vector<ElementPlace> contact_places(const StaticSystem& system, const LineState& state);

/// Returns the ends of the contacts as short stretches by distance from the tensioner, for mesh refinement.
std::vector<LineStretch> contact_edges(const StaticSystem& system, const std::vector<BedContact>& contacts);

}  // namespace overbend
