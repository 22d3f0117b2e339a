/// A lay that is solved in an instant, for tests of the dynamic command.
#pragma once

#include <stdexcept>
#include <string>

namespace overbend::testing {

/// `text` with the one place where `old` stands changed.
inline std::string with(std::string text, const std::string& old, const std::string& new_text) {
  const std::size_t index = text.find(old);
  if (index == std::string::npos) throw std::runtime_error("no '" + old + "' in the model");
  return text.replace(index, old.size(), new_text);
}

/// Five boxes, a coarse mesh, a random sea and a heaving barge: fifteen seconds of motion, a third of them build-up.
inline const std::string kSmallLay = R"(overbend: 1
title: small lay
environment:
  water_depth: 20 m
  seabed: {stiffness: 100 kN/m^2, friction: 0.3}
  waves: {type: jonswap, hs: 1 m, tp: 7 s, from: 60 deg, components: 20, seed: 3}
pipe:
  steel: {outside_diameter: 12.75 in, wall_thickness: 12.7 mm, yield_stress: 414 MPa}
  coatings: [{name: concrete, thickness: 40 mm, weight_density: 24 kN/m^3}]
vessel:
  stern_shoe: {x: -60 m, z: 4 m}
  motion: {harmonic: {heave: {amplitude: 0.3 m, period: 7 s}, pitch: {amplitude: 0.5 deg, period: 7 s}}}
tensioner: {x: -40 m, z: 1.6 m, tension: 300 kN}
rollers: {plain: {bottom: {radius: 0.15 m, face: 1 m}}}
supports:
  ramp:
    roller: plain
    boxes: [{x: -25 m, z: 1.07 m}, {x: -15 m, z: 0.06 m}, {x: -5 m, z: -1.63 m}]
  stinger:
    roller: plain
    boxes: [{x: 5 m, z: -4.03 m}, {x: 15 m, z: -7.18 m}]
analysis:
  mesh: {overbend_element: 2.5 m, touchdown_element: 4 m, longest_element: 8 m}
  dynamic: {duration: 10 s, build_up: 5 s, output_step: 0.5 s}
)";

inline const std::string kMoving =
    "motion: {harmonic: {heave: {amplitude: 0.3 m, period: 7 s}, pitch: {amplitude: 0.5 deg, period: 7 s}}}";
inline const std::string kWaves = "waves: {type: jonswap, hs: 1 m, tp: 7 s, from: 60 deg, components: 20, seed: 3}";

}  // namespace overbend::testing
