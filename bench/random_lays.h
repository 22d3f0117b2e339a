/// Random but sensible lays, the same from the same seed on every machine.
///
/// Pipes of 6 to 48 inch, depths of 10 to 2,500 m, S-lay and J-lay, 3 to 30 boxes of 1 to 4 rows, tension 1.05 to 4
/// times the minimum that the hanging pipe needs. A lay is sensible when its stinger bends the pipe within 0.15 to 0.3
/// % strain and ends near the angle at which a pipe of that tension would leave it.
#pragma once

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "base/constants.h"
#include "model/model.h"

namespace overbend {

/// Own conversion to doubles: the standard's distributions differ between libraries.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : generator_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(generator_() >> 11) * 0x1.0p-53;
  }
  double log_between(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }
  int integer(int low, int high) {
    return low + static_cast<int>(generator_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double p) { return between(0.0, 1.0) < p; }

 private:
  std::mt19937_64 generator_;
};

inline constexpr double kInch = 0.0254;

/// Steel, a corrosion coating, and concrete until the empty pipe has the wanted specific gravity.
inline SectionDescription random_pipe(Dice& dice, double depth) {
  const std::vector<double> sizes{6.625, 8.625, 10.75, 12.75, 14, 16, 18, 20, 24, 28, 30, 32, 36, 40, 42, 48};
  const int last = depth > 1000.0 ? 8 : static_cast<int>(sizes.size()) - 1;  // no one lays 48 inch in 2,500 m
  SectionDescription pipe;
  pipe.steel.outside_diameter = sizes[static_cast<std::size_t>(dice.integer(0, last))] * kInch;
  const double ratio = depth > 1000.0 ? dice.between(13.0, 20.0) : dice.between(18.0, 40.0);
  pipe.steel.wall_thickness = pipe.steel.outside_diameter / ratio;
  pipe.steel.yield_stress = 448e6;
  pipe.coatings = {{"corrosion coating", 0.003, 9.3e3}};
  pipe.hydrodynamics.drag_axial = 0.03;
  const double wanted = dice.between(1.1, 1.6);
  for (int i = 0; i < 200; ++i) {
    const Section section = derive_section("pipe", pipe, 10.05e3);
    if (section.weight_in_air > wanted * 10.05e3 * section.external_area) {
      break;
    }
    pipe.coatings.resize(1);
    pipe.coatings.push_back({"concrete", 0.002 * (i + 1), 30e3});
  }
  return pipe;
}

/// Ramp boxes on a level line, then ramp and stinger on one arc, to the angle at which the pipe wants to leave.
inline void random_supports(Dice& dice, Description& d, double departure) {
  const double strain = dice.between(0.0015, 0.003);
  const double radius = std::max(60.0, 0.5 * d.pipe.section.steel.outside_diameter / strain);
  const double end_angle = std::clamp(departure * dice.between(0.8, 1.1), 4.0 * kDegree, 75.0 * kDegree);
  const double arc = radius * end_angle;
  const double level = dice.between(10.0, 40.0);
  const int boxes = std::clamp(static_cast<int>((arc + level) / dice.between(4.0, 12.0)), 3, 30);
  const double spacing = (arc + level) / boxes;
  RollerKindDescription kind;
  kind.name = "roller";
  kind.bottom = {dice.between(0.1, 0.25), dice.between(0.5, 1.5)};
  // No one lays across a current or a slope without upright side rollers.
  const bool current = !d.environment.current.empty() || d.environment.seabed.slope > 0.0;
  if (current || dice.chance(0.5)) {
    const double angle = dice.between(current ? 75.0 : 45.0, 90.0) * kDegree;
    kind.sides = SideRollerDescription{kind.bottom.radius, dice.between(0.6, 1.2), angle, dice.between(0.02, 0.1)};
  }
  if (dice.chance(0.3)) {
    kind.stiffness = dice.log_between(1e7, 1e9);
  }
  d.rollers = {kind};
  const int rows = dice.integer(1, 4);
  const double length = std::min(0.8 * spacing, dice.between(1.5, 5.0));
  const double noise = dice.between(0.0, 0.01);
  for (int i = 0; i < boxes; ++i) {
    const double u = spacing * (i + 0.6) - level;  // along the support line, the arc starts at 0
    const double angle = std::max(u, 0.0) / radius;
    BoxDescription box;
    box.name = fmt::format("box {}", i + 1);
    box.structure = angle < 0.5 * end_angle ? Structure::ramp : Structure::stinger;
    box.x = std::min(u, 0.0) + radius * std::sin(angle);
    box.z = -radius * (1.0 - std::cos(angle)) + dice.between(-noise, noise);
    box.length = length;
    box.rows = rows;
    box.roller = kind.name;
    d.supports.boxes.push_back(box);
  }
  d.tensioner.x = -level - dice.between(5.0, 20.0);
}

inline Description random_lay(std::uint64_t seed) {
  Dice dice(seed);
  Description d;
  d.title = fmt::format("random lay {}", seed);
  d.environment.water_depth = dice.log_between(10.0, 2500.0);
  d.environment.seabed.stiffness = dice.log_between(2e4, 1e6);
  d.pipe.section = random_pipe(dice, d.environment.water_depth);
  d.vessel.heading = dice.between(0.0, 2.0 * std::numbers::pi);
  d.vessel.stern_shoe_x = -60.0;
  d.vessel.stern_shoe_z = dice.between(2.0, 10.0);
  if (dice.chance(0.25)) {
    d.environment.seabed.slope = dice.between(0.0, 3.0) * kDegree;
    d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.5;
    d.environment.seabed.slope_towards = dice.between(0.0, 2.0 * std::numbers::pi);
  }
  if (dice.chance(0.4)) {
    d.environment.seabed.friction_lateral = 0.5;
    const double towards = dice.between(0.0, 2.0 * std::numbers::pi);
    const double speed = dice.between(0.1, 0.8);
    d.environment.current = {{0.0, speed, towards},
                             {d.environment.water_depth, 0.2 * speed, towards + dice.between(-0.5, 0.5)}};
  }
  const bool j_lay = d.environment.water_depth > 150.0 && dice.chance(0.4);
  const Section pipe = derive_section("pipe", d.pipe.section, d.environment.water_weight_density);
  const double above = j_lay ? dice.between(10.0, 40.0) : d.vessel.stern_shoe_z;
  const double min_value = pipe.weight_submerged * d.environment.water_depth + pipe.weight_in_air * above;
  const double factor = dice.log_between(1.05, 4.0);
  d.tensioner.tension = factor * min_value;
  if (j_lay) {
    d.tensioner.guide = Guide::pinned;
    d.tensioner.z = above - d.vessel.stern_shoe_z;
    return d;
  }
  d.tensioner.z = 0.5 * pipe.outer_diameter;
  // The pipe of a heavy stinger leaves where the hanging line has the support's slope; bending lets a stiff pipe leave
  // flatter.
  const double bottom = std::max((factor - 1.0) * min_value, std::cbrt(pipe.EI * std::pow(pipe.weight_submerged, 2)));
  const double rise = 1.0 + pipe.weight_submerged * d.environment.water_depth / bottom;
  random_supports(dice, d, std::acos(1.0 / rise));
  return d;
}

/// From the same seed, so that lays without `routes` stay what they are.
inline void put_on_route(std::uint64_t seed, Description& d) {
  Dice dice(seed + 1000003);
  d.environment.seabed.friction_lateral = dice.between(0.3, 0.8);
  if (d.environment.current.empty() && dice.chance(0.6)) {
    const double towards = dice.between(0.0, 2.0 * std::numbers::pi), speed = dice.between(0.1, 0.8);
    d.environment.current = {{0.0, speed, towards}, {d.environment.water_depth, 0.2 * speed, towards}};
  }
  if (dice.chance(0.5)) return;
  const Section pipe = derive_section("pipe", d.pipe.section, d.environment.water_weight_density);
  const double min_value = pipe.weight_submerged * d.environment.water_depth;
  const double held = std::max(*d.tensioner.tension - min_value, 0.05 * min_value) /
                      (d.environment.seabed.friction_lateral * pipe.weight_submerged);
  const double sharpest = 1000.0 * d.pipe.section.steel.outside_diameter;  // no one bends a pipe more on purpose
  const double length = dice.between(1.0, 4.0) * std::sqrt(held * d.environment.water_depth);
  d.route.legs = {{length, 0.0, 0.0},
                  {0.0, std::max(dice.between(0.6, 3.0) * held, sharpest),
                   (dice.chance(0.5) ? 1.0 : -1.0) * dice.between(2.0, 40.0) * kDegree}};
}

inline MaterialDescription random_material(std::uint64_t seed) {
  Dice dice(seed);
  MaterialDescription material;
  material.law = MaterialLaw::ramberg_osgood;
  material.hardening_exponent = dice.between(8.0, 40.0);
  return material;
}

}  // namespace overbend
