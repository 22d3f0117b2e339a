/// Stresses and strains of stations from the moments and forces of their cuts.
#pragma once

#include <vector>

#include "mechanics/plastic_bending.h"
#include "model/model.h"
#include "results/static_results.h"
#include "system/line_mesh.h"

namespace overbend {

/// A station before its stresses are known.
struct StationCut {
  Station station;
  int section = 0;
  Vec3 tangent = Vec3::UnitX();  ///< Unit vector along the pipe, W.
  Vec3 bend = Vec3::Zero();      ///< Moment as a vector towards the centre of the curve: EI k of linear steel [N m].
};

/// Curvature, stress and strain of all stations, from the anchor to the tensioner. Where steel yields it is bent from
/// station to station on its way from the tensioner, by the moments of the cuts; where a line has a past, `memory`
/// gives what its Gauss points have become, kGaussPoints per element of `mesh`: the nearest one's is taken.
std::vector<Station> finish_stations(const Model& model, std::vector<StationCut> cuts, const LineMesh& mesh,
                                     const std::vector<BendingMemory>& memory);

}  // namespace overbend
