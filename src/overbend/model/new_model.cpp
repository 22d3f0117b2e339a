#include "model/new_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <vector>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/text.h"
#include "base/units.h"
#include "model/pipe/section.h"

namespace overbend {
namespace {

constexpr double kMaxBargeDepth = 300.0;  // limit for flat barges, which lack the tension and the stinger for more [m]
constexpr double kYoungsModulus = 207e9;  // [Pa]
constexpr double kWaterWeightDensity = 10.05e3;  // [N/m3]

constexpr std::array kWalls = {4.8,  5.6,  6.4,  7.1,  7.9,  8.7,  9.5,  10.3, 11.1, 11.9, 12.7, 14.3,
                               15.9, 17.5, 19.1, 20.6, 22.2, 23.8, 25.4, 27.0, 28.6, 30.2, 31.8, 33.3,
                               34.9, 36.5, 38.1, 39.7, 41.3, 44.5, 47.6, 50.8, 54.0, 57.2, 60.3};

/// Value of an option: a value, an error message, or neither if the option is absent.
struct OptionReading {
  std::optional<double> value;
  std::string error;
};

OptionReading read_flag(const std::string& flag, const std::string& text, const std::string& si_unit, double low,
                        double high) {
  if (text.empty()) return {};
  const QuantityReading reading = parse_quantity(text, si_unit);
  if (!reading.value) {
    return {{},
            flag + ": found " + reading.found + ", expected " + dimension_phrase(si_unit) + " with its unit; " +
                reading.hint};
  }
  if (*reading.value >= low && *reading.value <= high) return {reading.value, {}};
  const std::string unit = usual_units(si_unit).front();
  return {{},
          flag + ": found " + reading.found + ", expected from " + format_quantity(low, si_unit, unit) + " to " +
              format_quantity(high, si_unit, unit)};
}

/// Returns the sizes of API 5L on both sides of a number that is not a nominal size, such as "30 or 32".
std::string sizes_near(double inches) {
  std::string below, above;
  for (int size = 4; size <= 48 && above.empty(); size += 2) (size < inches ? below : above) = std::to_string(size);
  return join_items(below.empty()   ? std::vector{above}
                    : above.empty() ? std::vector{below}
                                    : std::vector{below, above},
                    "or");
}

/// "16" and "16 in" are nominal sizes; any other length is the outside diameter.
OptionReading read_pipe_size(const std::string& text) {
  const std::size_t unit_at = text.find_last_not_of(" in\"");
  const bool inches = unit_at != std::string::npos && text.find_first_not_of("0123456789.", 0) > unit_at;
  if (inches) {
    const auto number = parse_number(text.substr(0, unit_at + 1));
    const auto diameter = number ? nominal_diameter(*number) : std::nullopt;
    if (diameter) return {diameter, {}};
    if (number) {
      return {{},
              "--pipe: found '" + text + "', expected a nominal size [in], here " + sizes_near(*number) +
                  ", or an outside diameter with its unit, such as '406.4 mm'"};
    }
  }
  return read_flag("--pipe", text, "m", 0.08, 1.6);
}

SectionDescription compute_section(const NewModel& model) {
  SectionDescription section;
  section.steel.outside_diameter = model.diameter;
  section.steel.wall_thickness = model.wall;
  section.steel.youngs_modulus = kYoungsModulus;
  section.steel.yield_stress = model.yield;
  if (model.coating > 0.0) section.coatings.push_back({"corrosion coating", model.coating, 9.32e3});
  if (model.concrete > 0.0) {
    section.coatings.push_back({"concrete", model.concrete, 22e3});
    section.joint = JointDescription{12.2, 0.7, 10.065e3};
  }
  return section;
}

/// External pressure at collapse, API RP 1111: elastic and plastic collapse combined [Pa].
double collapse_pressure(double diameter, double wall, double yield) {
  const double slenderness = wall / diameter;
  const double elastic = 2.0 * kYoungsModulus * std::pow(slenderness, 3) / (1.0 - 0.3 * 0.3);
  const double plastic = 2.0 * yield * slenderness;
  return elastic * plastic / std::hypot(elastic, plastic);
}

/// Ratio of weight in air to buoyancy.
double specific_gravity(const NewModel& model) {
  const Section section = derive_section("", compute_section(model), kWaterWeightDensity);
  return section.weight_in_air / (section.weight_in_air - section.weight_submerged);
}

/// Returns true if the wall is a sufficient first choice: D/t at most 40, external pressure at most half the collapse
/// pressure, and on-bottom specific gravity sufficient.
bool is_wall_sufficient(NewModel model, double wall) {
  constexpr double kMaxDiameterOverWall = 40.0, kPressureShare = 0.5, kSpecificGravity = 1.1;
  model.wall = wall;
  return model.diameter <= kMaxDiameterOverWall * wall && specific_gravity(model) >= kSpecificGravity &&
         kPressureShare * collapse_pressure(model.diameter, wall, model.yield) >= kWaterWeightDensity * model.depth;
}

/// Chooses the minimum sufficient wall of the list (API 5L) plus `more` sizes; returns an error message at the end of
/// the list.
std::string choose_wall(NewModel& model, int more) {
  const auto serves = [&](double millimetres) { return is_wall_sufficient(model, 1e-3 * millimetres); };
  const auto thinnest = std::min(ranges::find_if(kWalls, serves), kWalls.end() - 1);
  if (kWalls.end() - thinnest <= more) {
    return fmt::format(
        "no wall of API 5L up to {:.4g} mm is sufficient for this pipe in {:.5g} m of water: choose a smaller pipe, a "
        "stronger steel or less depth",
        kWalls.back(), model.depth);
  }
  model.wall = 1e-3 * *(thinnest + more);
  return {};
}

double round_up(double value, double step) {
  return step * std::ceil(value / step - 1e-9);
}

/// Horizontal tension of a catenary that keeps the sagbend at 60 % of yield [N].
double sagbend_tension(const NewModel& model) {
  return model.submerged_weight * kYoungsModulus * 0.5 * model.diameter / (0.6 * model.yield);
}

/// Horizontal tension for which a catenary leaves the surface at an angle [N].
double tension_for_angle(const NewModel& model, double angle) {
  return model.submerged_weight * model.depth * std::cos(angle) / (1.0 - std::cos(angle));
}

/// Max. departure angle of a stinger: 30 deg in shallow water, 60 deg from 1100 m.
double max_departure_angle(double depth) {
  return (30.0 + 30.0 * std::clamp((depth - 100.0) / 1000.0, 0.0, 1.0)) * kDegree;
}

/// Chooses the tension if it is not given, and the resulting departure angle. Returns an error message if the tension
/// cannot carry the pipe.
std::string choose_tension(NewModel& model, const std::optional<double>& said, double margin) {
  const VesselSize vessel = vessel_size(model.vessel);
  const double in_air = model.weight_in_air * (vessel.depth - vessel.draught + model.tensioner_height);
  const double suspended_weight = model.submerged_weight * model.depth + in_air;
  double horizontal = sagbend_tension(model);
  if (model.stinger) horizontal = std::max(horizontal, tension_for_angle(model, max_departure_angle(model.depth)));
  horizontal *= margin;
  const double wanted = round_up(horizontal + suspended_weight, horizontal > 1e6    ? 50e3
                                                                : horizontal > 20e3 ? 5e3
                                                                                    : 1e3);
  model.tension = said.value_or(wanted);
  horizontal = model.tension - suspended_weight;
  if (horizontal < 0.2 * sagbend_tension(model)) {
    return "--tension: " + format_quantity(model.tension, "N", "kN") + " is too low for this pipe and depth; about " +
           format_quantity(wanted, "N", "kN") + " would be sufficient";
  }
  model.departure_angle = std::acos(horizontal / (model.stinger ? model.tension - in_air : model.tension));
  return {};
}

/// Max. distance between boxes at which a pipe under tension still follows the circle rather than kinking at each box
/// [m].
double free_span(const NewModel& model) {
  const double bending_stiffness = derive_section("", compute_section(model), kWaterWeightDensity).EI;
  return std::max(1.5, 0.8 * std::sqrt(bending_stiffness / model.tension));
}

int boxes_for(double length, double spacing) {
  return std::clamp(1 + static_cast<int>(std::ceil(length / spacing - 0.05)), 2, 60);
}

/// Places ramp and stinger on one circle: the ramp turns the pipe by up to 12 deg, the stinger on to the departure
/// angle. Returns an error message if the requested boxes do not fit.
std::string choose_stinger(NewModel& model, const std::optional<double>& said_radius, double margin, int said_boxes) {
  constexpr double kMaxShoeDrop = 3.0, kMaxShoeAngle = 0.21, kMinBoxSpacing = 1.0;
  const double min_radius = kYoungsModulus * 0.5 * model.diameter / (0.75 * model.yield);
  model.stinger_radius = said_radius.value_or(round_up(margin * min_radius, 10.0));
  const double at_shoe =
      std::min({kMaxShoeAngle, 0.4 * model.departure_angle, std::acos(1.0 - kMaxShoeDrop / model.stinger_radius)});
  model.circle_start = -model.stinger_radius * std::sin(at_shoe);
  model.stinger_tip = model.circle_start + model.stinger_radius * std::sin(model.departure_angle);
  model.stinger_start = std::min(4.0, 0.2 * model.stinger_tip);
  const double room = model.stinger_tip - model.stinger_start;
  const int chosen = boxes_for(room, std::min(5.0, free_span(model)));
  model.ramp_boxes = boxes_for(-model.circle_start, std::min(10.0, free_span(model)));
  model.boxes = said_boxes > 0 ? said_boxes : chosen;
  if (model.circle_start > -2.0 || room < kMinBoxSpacing * (model.boxes - 1)) {
    return fmt::format("a stinger of {:.4g} m radius and {:.3g} m length is too short for {} boxes; {}",
                       model.stinger_radius, room, model.boxes, "give fewer boxes, a larger radius or less tension");
  }
  return {};
}

}  // namespace

VesselSize vessel_size(const std::string& vessel) {
  if (vessel == "ship") return {220.0, 38.0, 18.0, 9.0};
  return {120.0, 30.0, 9.0, vessel == "BGL-1" ? 5.182 : 5.2};
}

std::string text_or_value(const std::string& text, double value, const std::string& si_unit, const std::string& unit) {
  const auto plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view(" ./^+-").find(static_cast<char>(c)) != std::string_view::npos;
  };
  const std::optional<double> said = parse_quantity(text, si_unit).value;
  const bool same = said && std::abs(*said - value) <= 1e-12 * std::abs(value);
  return same && ranges::all_of(text, plain) ? text : format_quantity(value, si_unit, unit);
}

std::span<const double> api_walls() {
  return kWalls;
}

std::optional<double> nominal_diameter(double inches) {
  constexpr std::array<std::pair<int, double>, 5> kSmall = {
      {{4, 0.1143}, {6, 0.1683}, {8, 0.2191}, {10, 0.2731}, {12, 0.3239}}};
  for (const auto& [size, diameter] : kSmall) {
    if (inches == size) return diameter;
  }
  const bool even = std::fmod(inches, 2.0) == 0.0;
  if (even && inches >= 14.0 && inches <= 48.0) return inches * 0.0254;
  return std::nullopt;
}

std::variant<NewModel, std::string> choose_model(const NewOptions& options, const NewMargins& margins) {
  const OptionReading pipe = read_pipe_size(options.pipe);
  const OptionReading depth = read_flag("--depth", options.depth, "m", 5.0, 4000.0);
  const OptionReading wall = read_flag("--wall", options.wall, "m", 0.002, 0.1);
  const OptionReading yield = read_flag("--yield", options.yield, "N/m^2", 100e6, 1000e6);
  const OptionReading coating = read_flag("--coating", options.coating, "m", 0.0, 0.3);
  const OptionReading concrete = read_flag("--concrete", options.concrete, "m", 0.0, 0.3);
  const OptionReading radius = read_flag("--stinger-radius", options.stinger_radius, "m", 20.0, 2000.0);
  const OptionReading tension = read_flag("--tension", options.tension, "N", 1e3, 50e6);
  for (const OptionReading* said : {&pipe, &depth, &wall, &yield, &coating, &concrete, &radius, &tension}) {
    if (!said->error.empty()) return said->error;
  }
  if (!pipe.value) return "--pipe is missing: the nominal size in inches, or the outside diameter with its unit";
  if (!depth.value) return "--depth is missing: the water depth with its unit, such as '89 m'";

  NewModel model;
  model.said = options;
  model.stinger = options.lay == "s";
  model.diameter = *pipe.value;
  model.depth = *depth.value;
  model.yield = yield.value.value_or(414e6);
  model.coating = coating.value.value_or(0.0);
  model.concrete = concrete.value.value_or(0.0);
  if (wall.value) {
    model.wall = *wall.value;
  } else if (const std::string error = choose_wall(model, margins.walls); !error.empty()) {
    return error;
  }
  if (model.wall >= 0.5 * model.diameter) return "--wall: thicker than the pipe's radius";
  if (!options.vessel.empty() && options.vessel != "ship" && model.depth > kMaxBargeDepth) {
    return fmt::format("--vessel: found '{}', expected ship in more than {:.4g} m of water", options.vessel,
                       kMaxBargeDepth);
  }
  model.vessel = !options.vessel.empty() ? options.vessel : model.depth <= 200.0 && model.stinger ? "barge" : "ship";
  model.title = !options.title.empty()
                    ? options.title
                    : fmt::format("{:.4g} mm pipe in {} of water, {}-lay", model.diameter * 1e3,
                                  text_or_value(options.depth, model.depth, "m", "m"), model.stinger ? "S" : "J");
  model.tensioner_height = model.stinger ? 1.4 : 15.0;
  const Section section = derive_section("", compute_section(model), kWaterWeightDensity);
  model.weight_in_air = section.weight_in_air;
  model.submerged_weight = section.weight_submerged;
  if (model.submerged_weight <= 0.0) {
    return "the pipe floats; give it a thicker wall or concrete coating (--wall, --concrete)";
  }
  if (const std::string error = choose_tension(model, tension.value, margins.tension); !error.empty()) return error;
  if (model.stinger) {
    const std::string error = choose_stinger(model, radius.value, margins.radius, options.boxes);
    if (!error.empty()) return error;
  }
  return model;
}

}  // namespace overbend
