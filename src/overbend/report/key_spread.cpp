#include "report/key_spread.h"

#include <array>
#include <utility>

namespace overbend {
namespace {

constexpr std::array<std::pair<const char*, Spread DynamicResults::*>, 5> kOfLine = {
    {{"top_tension", &DynamicResults::top_tension},
     {"bottom_tension", &DynamicResults::bottom_tension},
     {"lay_back", &DynamicResults::lay_back},
     {"departure_angle", &DynamicResults::departure_angle},
     {"stinger_tip_clearance", &DynamicResults::stinger_tip_clearance}}};

constexpr std::array<std::pair<const char*, DynamicExtreme DynamicRegion::*>, 4> kOfRegion = {
    {{"bending_moment", &DynamicRegion::bending_moment},
     {"bending_stress", &DynamicRegion::bending_stress},
     {"von_mises", &DynamicRegion::von_mises},
     {"strain", &DynamicRegion::strain}}};

/// Whether a history has this name, or keeps the peaks of it between its rows.
bool is(const std::string& name, const std::string& quantity) {
  return name == quantity || name == quantity + "_peak";
}

std::optional<Spread> of_region(const DynamicRegion& region, const std::string& prefix, const std::string& name) {
  for (const auto& [quantity, member] : kOfRegion) {
    if (is(name, prefix + quantity)) return (region.*member).over_time;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Spread> key_spread(const DynamicResults& results, const std::string& name) {
  for (const auto& [quantity, member] : kOfLine) {
    if (is(name, quantity)) return results.*member;
  }
  if (const auto spread = of_region(results.overbend, "overbend_", name)) return spread;
  if (const auto spread = of_region(results.sagbend, "sagbend_", name)) return spread;
  for (const SupportDynamics& box : results.supports) {
    if (name == "support/" + box.name + "/reaction") return box.reaction;
    if (name == "support/" + box.name + "/separation") return box.separation;
  }
  return std::nullopt;
}

}  // namespace overbend
