#include "checks/fatigue_spot.h"

namespace overbend {
namespace {

FatigueMedium medium_at(const FatigueSpotDescription& spot, const Section& section, double z) {
  if (spot.medium) return *spot.medium;
  if (spot.inside) {
    return section.contents_weight_density > 0.0 ? FatigueMedium::seawater_free : FatigueMedium::air;
  }
  return z > 0.0 ? FatigueMedium::air : FatigueMedium::seawater_protected;
}

}  // namespace

std::vector<FatigueSpotDescription> fatigue_spots(const FatigueDescription& fatigue) {
  if (!fatigue.spots.empty()) return fatigue.spots;
  return {{"outside", false, FatigueCurve::d, {}, {}}, {"inside", true, FatigueCurve::f1, {}, {}}};
}

FatiguePlace fatigue_place(const FatigueDescription& fatigue, const FatigueSpotDescription& spot,
                           const Section& section, double z) {
  FatiguePlace place;
  place.medium = medium_at(spot, section, z);
  place.curve = sn_curve(spot.curve, place.medium, fatigue.edition);
  place.stress_factor =
      spot.stress_factor.value_or(hi_lo_factor(fatigue.hi_lo, section.steel_diameter, section.wall_thickness));
  place.thickness_factor = thickness_effect(place.curve, fatigue.thickness.value_or(section.wall_thickness));
  return place;
}

}  // namespace overbend
