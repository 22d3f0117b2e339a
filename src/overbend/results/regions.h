/// Assignment of positions along the line to regions: one rule for tables, extremes, histories and code checks. See
/// docs/theory/regions.md.
#pragma once

#include "results/check_results.h"
#include "results/static_results.h"

namespace overbend {

/// Boundaries of the regions of a line, by arc length from the anchor [m].
struct Regions {
  double touchdown = 0.0;
  double inflection = 0.0;  ///< Upper end of the sagbend.
  double departure = 0.0;   ///< Last contact with a support, if any.
  bool carried = false;     ///< True if a support carries the pipe: the region above the inflection is then the
                            ///< overbend, otherwise the tower.

  /// Returns the region at arc length s from the anchor [m].
  Region of(double s) const {
    if (s < touchdown) return Region::seabed;
    if (s <= inflection && !supported(s)) return Region::sagbend;
    return carried ? Region::overbend : Region::tower;
  }
  /// True if the position lies over the supports, which determine the shape of the pipe.
  bool supported(double s) const { return carried && s >= departure; }

  /// True if the station is the last over the supports before a free end; `below` is the position of the next one. The
  /// station belongs to the free end as well: the pipe just below the last contact has the same load effects.
  bool leaves(double below, double s) const {
    return carried && inflection < departure && below < departure && s >= departure;
  }

  /// True if the station is the first of the suspended pipe; `below` is the position of the next one. The station
  /// belongs to the seabed as well: the end of the pipe on the seabed has the load effects of touchdown.
  bool lands(double below, double s) const { return below < touchdown && s >= touchdown; }

  /// Returns the region for the code checks, which distinguish the supported part of the overbend from its free end.
  CheckRegion code_check_region(double s) const {
    switch (of(s)) {
      case Region::tower:
        return CheckRegion::tower;
      case Region::overbend:
        return supported(s) ? CheckRegion::overbend : CheckRegion::tip;
      case Region::sagbend:
        return CheckRegion::sagbend;
      case Region::seabed:
        break;
    }
    return CheckRegion::seabed;
  }
};

/// Returns the regions of a static state.
inline Regions regions(const StaticResults& statics) {
  return {statics.touchdown.s, statics.inflection_s, statics.departure_s, statics.overbend.has_value()};
}

}  // namespace overbend
