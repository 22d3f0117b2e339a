#include "report/static_value.h"

#include <array>
#include <utility>

namespace overbend {
namespace {

using Named = std::pair<const char*, Extreme RegionResult::*>;

constexpr std::array<Named, 4> kOfRegion = {{{"bending_moment", &RegionResult::bending_moment},
                                             {"bending_stress", &RegionResult::bending_stress},
                                             {"von_mises", &RegionResult::von_mises},
                                             {"strain", &RegionResult::strain}}};

std::optional<double> of_region(const RegionResult& region, const std::string& region_name, const std::string& name) {
  for (const auto& [quantity, member] : kOfRegion) {
    if (name == region_name + "_" + quantity || name == region_name + "_" + quantity + "_peak") {
      return (region.*member).value;
    }
  }
  return std::nullopt;
}

std::optional<double> of_support(const DynamicResults& results, const std::string& name) {
  for (const SupportDynamics& box : results.supports) {
    if (name == "support/" + box.name + "/reaction") return box.static_reaction;
    if (name == "support/" + box.name + "/separation") return box.static_separation;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> static_value(const StaticResults& statics, const DynamicResults& results,
                                   const std::string& name) {
  if (name == "top_tension" || name == "top_tension_peak" || name == "top_tension_low") return statics.top_tension;
  if (name == "smallest_tension") return statics.smallest_tension.value;
  if (name == "bottom_tension") return statics.bottom_tension;
  if (name == "lay_back") return statics.lay_back;
  if (name == "departure_angle") return statics.departure_angle;
  if (name == "stinger_tip_clearance") return statics.stinger_tip_clearance;
  if (statics.overbend) {
    if (const auto value = of_region(*statics.overbend, "overbend", name)) return value;
  }
  if (statics.tower) {
    if (const auto value = of_region(*statics.tower, "tower", name)) return value;
  }
  if (const auto value = of_region(statics.sagbend, "sagbend", name)) return value;
  return of_support(results, name);
}

}  // namespace overbend
