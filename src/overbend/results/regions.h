/// Which part of the line a place belongs to: one rule for tables, extremes, histories and code checks.
/// docs/theory/regions.md.
#pragma once

#include "results/check_results.h"
#include "results/static_results.h"

namespace overbend {

/// Where the regions of a line meet, by arc length from the anchor [m].
struct Regions {
  double touchdown = 0.0;
  double inflection = 0.0;  ///< Upper end of the sagbend.
  double departure = 0.0;   ///< Last contact with a support, where one carries.
  bool carried = false;     ///< A support carries the pipe: above the inflection lies the overbend, else the tower.

  Region of(double s) const {
    if (s < touchdown) return Region::seabed;
    if (s <= inflection && !supported(s)) return Region::sagbend;
    return carried ? Region::overbend : Region::tower;
  }
  /// Whether the place lies over the supports, where they give the pipe its shape.
  bool supported(double s) const { return carried && s >= departure; }

  /// Whether the station is the last over the supports before a free end, `below` being the place of the next. It is of
  /// the free end as well: however close below the last contact, the pipe bears what it does there.
  bool leaves(double below, double s) const {
    return carried && inflection < departure && below < departure && s >= departure;
  }

  /// Whether the station is the first of the suspended pipe, `below` being the place of the next. It is of the seabed
  /// as well: the pipe that lies there bears at its end what it does at touchdown.
  bool lands(double below, double s) const { return below < touchdown && s >= touchdown; }

  /// The same for the code checks, which tell the overbend over the supports from its free end.
  CheckRegion check_of(double s) const {
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

/// Of a static state.
inline Regions regions(const StaticResults& statics) {
  return {statics.touchdown.s, statics.inflection_s, statics.departure_s, statics.overbend.has_value()};
}

}  // namespace overbend
