/// Pieces of the recovery that its files share.
#pragma once

#include <string>
#include <vector>

#include "statics/recovery.h"

namespace overbend {

/// Cut at xi inside an element, by balance of what lies between it and the element's first node.
CutForces cut_at(const StaticSystem& system, const LineState& state, const std::vector<CutForces>& cuts, int element,
                 double xi);

/// A station before its stresses are known.
struct StationCut {
  Station station;
  int section = 0;
  Vec3 tangent = Vec3::UnitX();  ///< Unit vector along the pipe, W.
  Vec3 bend = Vec3::Zero();      ///< Moment as a vector towards the centre of the curve: EI k of linear steel [N m].
};
StationCut make_station(const StaticSystem& system, const LineState& state, const CutForces& cut, int element,
                        double xi);

/// Curvature, stress and strain of all stations, from the anchor to the tensioner. Where steel yields it is bent from
/// station to station on its way from the tensioner, by the moments of the cuts.
std::vector<Station> finish_stations(const Model& model, std::vector<StationCut> cuts);

/// The last support that carries the pipe, seen from the tensioner.
struct Departure {
  bool carried = false;  ///< Any support in contact.
  double s = 0.0;        ///< Arc length of the last contact [m].
  std::string support;
};

/// Separation and reaction of every roller, row and box, [silva2009] equations 19 to 21; uses the contacts of the last
/// evaluation.
Departure recover_supports(StaticResults& results, const StaticSystem& system, const LineState& state);

/// What the file wants, tension or anchor, beside what the recovered forces and places say; warns where they differ.
void warn_of_missed_target(StaticResults& results, const Model& model);

}  // namespace overbend
