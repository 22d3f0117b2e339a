/// Hull data of a vessel type: load RAOs, added mass, damping and stiffness, from which motions can be computed.
#pragma once

#include <string>

#include "orcaflex/translation.h"

namespace overbend::orcaflex {

/// True if a draught has all that a floating hull needs: load RAOs, added mass and damping by frequency, stiffness.
bool has_hull_data(const Object& draught);

/// Returns `vessel.motion.coupled` as comments, with mass, centre of gravity and radii of gyration of the draught, and
/// a reference to `file`: the file has no beam, depth and draught, which a hull that floats needs. `convention` has the
/// names of vessel type and draught.
std::string hull_data_text(const Translation& translation, const Object& draught, const std::string& file,
                           const std::string& convention);

}  // namespace overbend::orcaflex
