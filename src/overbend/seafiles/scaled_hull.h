/// Motion RAOs of a hull scaled from those of another, for a vessel whose own are not known.
#pragma once

#include <string>

#include "model/waves/rao_table.h"

namespace overbend {

/// Main dimensions in the water plane [m].
struct HullDimensions {
  double length = 0.0, beam = 0.0;
};

/// Froude scaling in deep water with a ratio r: frequencies by 1/sqrt(r), rotations per wave amplitude by 1/r, motions
/// in metres per metre and phases unchanged. r is the ratio of the lengths for surge, heave, pitch and yaw, that of the
/// beams for sway and roll. This is exact where both ratios are the same; the limits for long waves hold in any case.
/// Points of the vessel are scaled by length along it, by beam otherwise. Frequencies are those of the original under
/// both ratios.
RaoTable scale_raos(const RaoTable& raos, const HullDimensions& original, const HullDimensions& scaled);

/// A CSV file in the convention of the house that read_raos() takes, with its `assumption` in the header.
std::string rao_csv(const RaoTable& raos, const std::string& title, const std::string& assumption);

}  // namespace overbend
