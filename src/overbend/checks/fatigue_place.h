/// Places of a weld that fatigue is counted at: their S-N curve and the factors on the nominal stress range.
#pragma once

#include <vector>

#include "checks/fatigue_curve.h"
#include "model/pipe/section.h"

namespace overbend {

/// A place of the weld at a station.
struct FatiguePlace {
  double stress_factor = 1.0;     ///< Hot spot over nominal stress.
  double thickness_factor = 1.0;  ///< (t/25 mm)^k.
  FatigueMedium medium = FatigueMedium::air;
  SnCurve curve;

  double factor() const { return stress_factor * thickness_factor; }  ///< Of the nominal stress range.
};

/// Places of the weld that a model looks at: those of the file, or the two that stand for none.
std::vector<FatigueSpotDescription> fatigue_spots(const FatigueDescription& fatigue);

/// `z`: height of the station above the mean water level in the static state [m].
FatiguePlace fatigue_place(const FatigueDescription& fatigue, const FatigueSpotDescription& spot,
                           const Section& section, double z);

}  // namespace overbend
