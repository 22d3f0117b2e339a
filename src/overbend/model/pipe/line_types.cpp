#include "model/pipe/line_types.h"

#include <fmt/format.h>

#include <numbers>

#include "base/shown_unit.h"
#include "model/description/description_enum_names.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr double kRopeFriction = 0.6, kChainFriction = 1.0;  // on sand, typical values

struct RopeNumbers {
  double mass;             ///< Divided by the squared diameter [kg/m3].
  double axial_stiffness;  ///< Divided by the squared diameter [N/m2].
  double breaking_load;    ///< Divided by the squared diameter [N/m2].
  double volume_diameter;  ///< Divided by the diameter [-].
};

RopeNumbers find_numbers(RopeCore core) {
  if (core == RopeCore::wire) return {3989.7, 4.04e10, 6.334e8, 0.80};
  return {3610.9, 3.67e10, 5.842e8, 0.82};
}

struct ChainNumbers {
  double mass;                            ///< Divided by the squared diameter [kg/m3].
  double stiffness, stiffness_reduction;  ///< EA = first d^2 - second d^3 [N/m2, N/m3].
  double volume_diameter;                 ///< Divided by the diameter of the bar [-].
  double drag_normal, drag_axial;         ///< Based on the projected area of the volume diameter, as in catalogues.
};

ChainNumbers find_numbers(ChainLink link) {
  if (link == ChainLink::studless) return {20000.0, 8.56e10, 3.93e7, 1.80, 1.333, 0.639};
  return {21900.0, 8.80e10, 0.0, 1.89, 1.376, 0.741};
}

}  // namespace

LineTypeDescription wire_rope(double diameter, RopeCore core) {
  const RopeNumbers numbers = find_numbers(core);
  const double d2 = diameter * diameter;
  LineTypeDescription type;
  type.made_from = fmt::format("six-strand wire rope of {} with a {} core", shown_digits(diameter, section_length(), 4),
                               enum_name(core));
  type.diameter = type.drag_diameter = diameter;
  type.volume_diameter = numbers.volume_diameter * diameter;
  type.weight_in_air = numbers.mass * d2 * kGravity;
  type.axial_stiffness = numbers.axial_stiffness * d2;
  type.breaking_load = numbers.breaking_load * d2;
  type.compression = false;
  type.drag_normal = 1.8;
  type.friction = kRopeFriction;
  return type;
}

LineTypeDescription chain(double diameter, ChainLink link) {
  const ChainNumbers numbers = find_numbers(link);
  const double d2 = diameter * diameter, d3 = d2 * diameter;
  LineTypeDescription type;
  type.made_from = fmt::format("{} chain R4 of {}", enum_name(link), shown_digits(diameter, section_length(), 4));
  type.diameter = diameter;
  type.volume_diameter = type.drag_diameter = numbers.volume_diameter * diameter;
  type.weight_in_air = numbers.mass * d2 * kGravity;
  type.axial_stiffness = numbers.stiffness * d2 - numbers.stiffness_reduction * d3;
  type.breaking_load = 9.11e2 * diameter + 1.21e9 * d2 - 2.19e9 * d3;
  type.compression = false;
  type.drag_normal = numbers.drag_normal;
  type.drag_axial = numbers.drag_axial / std::numbers::pi;  // axial drag of a line refers to the circumference
  type.added_mass_axial = 0.5;
  type.friction = kChainFriction;
  return type;
}

bool bears_compression(const LineTypeDescription& type) {
  return type.compression.value_or(type.bending_stiffness > 0.0);
}

double submerged_weight(const LineTypeDescription& type, double water_weight_density) {
  const double volume = 0.25 * std::numbers::pi * type.volume_diameter * type.volume_diameter;
  return type.weight_in_air - water_weight_density * volume;
}

}  // namespace overbend
