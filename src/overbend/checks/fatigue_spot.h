/// Fatigue hot spots of a weld: their S-N curve and the factors on the nominal stress range.
#pragma once

#include <vector>

#include "checks/fatigue_curve.h"
#include "model/pipe/section.h"

namespace overbend {

/// Hot spot of the weld at a station.
struct FatiguePlace {
  double stress_factor = 1.0;     ///< Ratio of hot spot stress to nominal stress.
  double thickness_factor = 1.0;  ///< (t/25 mm)^k.
  FatigueMedium medium = FatigueMedium::air;
  SnCurve curve;

  double factor() const { return stress_factor * thickness_factor; }  ///< Factor on the nominal stress range.
};

/// Returns the hot spots of a model: those of the file, or the two defaults if there are none.
std::vector<FatigueSpotDescription> fatigue_spots(const FatigueDescription& fatigue);

/// Returns the hot spot. `z`: height of the station above the mean water level in the static state [m].
FatiguePlace fatigue_place(const FatigueDescription& fatigue, const FatigueSpotDescription& spot,
                           const Section& section, double z);

}  // namespace overbend
