/// Motion RAOs scaled from another hull, for a vessel whose RAOs are unknown.
#pragma once

#include <string>

#include "model/waves/rao_table.h"

namespace overbend {

/// Main dimensions of the water plane [m].
struct HullDimensions {
  double length = 0.0, beam = 0.0;
};

/// Froude scaling in deep water with a ratio r: frequencies by 1/sqrt(r), rotations per wave amplitude by 1/r, motions
/// in metres per metre and phases unchanged. r is the ratio of lengths for surge, heave, pitch and yaw, and of beams
/// for sway and roll. This is exact if both ratios are equal; the long-wave limits are always correct. Reference points
/// are scaled with length along the vessel and with beam otherwise. The frequencies are those of the original scaled by
/// both ratios.
RaoTable scale_raos(const RaoTable& raos, const HullDimensions& original, const HullDimensions& scaled);

/// Returns a CSV file in the internal convention for read_raos(), with `assumption` in the header.
std::string rao_csv(const RaoTable& raos, const std::string& title, const std::string& assumption);

}  // namespace overbend
