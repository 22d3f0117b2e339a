/// Change of reference point of hydrodynamic coefficients.
#pragma once

#include "model/description/hydrodynamic_data.h"

namespace overbend {

/// Reference points of the values in a file, frame V [m].
struct FilePoints {
  Vec3 reference = Vec3::Zero();    ///< Point of the motions and of the moments.
  Vec3 wave_origin = Vec3::Zero();  ///< Phases refer to the wave crest at this point; its height is not used.
};

/// Transforms added mass, damping, excitation, mean drift and stiffness to the reference point data.origin_V, for a
/// rigid hull without mean speed: A' = S^T A S, where S gives the motion of the file's point from that of the new one.
/// The water `depth` [m] determines the wave number that shifts the phases.
void move_coefficients(HydrodynamicData& data, const FilePoints& from, double depth);

/// Transforms a matrix of force over motion (stiffness, added mass) from the reference point `from` to `to` [m].
void move_matrix(Mat6& matrix, const Vec3& from, const Vec3& to);

}  // namespace overbend
