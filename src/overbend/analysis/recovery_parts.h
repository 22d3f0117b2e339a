/// Pieces of the recovery that its files share.
#pragma once

#include <string>
#include <vector>

#include "analysis/recovery.h"

namespace overbend {

/// Cut at xi inside an element, by balance of what lies between it and the element's first node.
CutForces cut_at(const LineSystem& system, const LineState& state, const std::vector<CutForces>& cuts, int element,
                 double xi);

Station make_station(const LineSystem& system, const LineState& state, const CutForces& cut, int element, double xi);

/// The last support that carries the pipe, seen from the tensioner.
struct Departure {
  bool carried = false;  ///< Any support in contact.
  double s = 0.0;        ///< Arc length of the last contact [m].
  std::string support;
};

/// Separation and reaction of every roller, row and box, [silva2009] equations 19 to 21; uses the contacts of the last
/// evaluation.
Departure recover_supports(StaticResults& results, const LineSystem& system, const LineState& state);

}  // namespace overbend
