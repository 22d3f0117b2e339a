/// Coefficients of a hull about another point of it.
#pragma once

#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Where the values of a file refer to, frame V [m].
struct FilePoints {
  Vec3 reference = Vec3::Zero();    ///< Motions are of this point, and moments about it.
  Vec3 wave_origin = Vec3::Zero();  ///< Phases count from the crest over it; its height means nothing.
};

/// Moves added mass, damping, excitation, mean drift and stiffness to data.origin_V as those of a rigid hull at rest:
/// A' = S^T A S with the motion S of the file's point by that of the new one. `depth` of the water [m] gives the wave
/// number by which phases move.
void move_coefficients(HydrodynamicData& data, const FilePoints& from, double depth);

}  // namespace overbend
