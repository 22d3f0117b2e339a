/// Stresses and strains of stations from the moments and forces at their cross-sections.
#pragma once

#include <vector>

#include "mechanics/plastic_bending.h"
#include "model/model.h"
#include "results/static_results.h"
#include "system/line_mesh.h"

namespace overbend {

/// Station without its stresses.
struct StationCut {
  Station station;
  int section = 0;
  Vec3 tangent = Vec3::UnitX();  ///< Unit vector along the pipe, W.
  Vec3 bend = Vec3::Zero();      ///< Moment as a vector towards the centre of curvature: EI k for linear steel [N m].
};

/// Sets curvature, stress and strain of all stations, from the anchor to the tensioner. Yielding steel is bent from
/// station to station on its way from the tensioner by the section moments; for a line with a load history, `memory`
/// gives the state of its Gauss points, kGaussPoints per element of `mesh`, and the nearest is used.
std::vector<Station> finish_stations(const Model& model, std::vector<StationCut> cuts, const LineMesh& mesh,
                                     const std::vector<BendingMemory>& memory);

}  // namespace overbend
