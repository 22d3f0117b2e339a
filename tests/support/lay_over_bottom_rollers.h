/// A lay over bottom rollers alone, from which a current across it drives the pipe.
#pragma once

#include <fmt/format.h>

#include "modelfile/reading/yaml_reader.h"

namespace overbend::testing {

/// The current runs to starboard [m/s]: with 0.2 the pipe keeps to its rollers, with 0.3 it lies under the last of
/// them, just beyond its end, with 0.5 metres below and next to most.
inline Description lay_over_bottom_rollers(double current) {
  const std::string text = fmt::format(
      R"(overbend: 1
title: bottom rollers alone
environment:
  water_depth: 58 m
  seabed: {{stiffness: 220 kN/m^2, friction: 0.4}}
  current: [{{depth: 0 m, speed: {} m/s, towards: 90 deg}}]
pipe:
  steel: {{outside_diameter: 273.1 mm, wall_thickness: 14.3 mm, yield_stress: 448 MPa}}
  coatings: [{{thickness: 2.8 mm, weight_density: 9.1 kN/m^3}}, {{thickness: 45 mm, weight_density: 29 kN/m^3}}]
vessel: {{stern_shoe: {{x: -47 m, z: 2.9 m}}}}
tensioner: {{x: -35.97863 m, z: 1.14485 m, incline: 2.5 deg, tension: 430 kN}}
rollers:
  r: {{bottom: {{radius: 0.12 m, face: 1.1 m}}}}
supports:
  ramp:
    roller: r
    boxes:
      - {{name: R1, x: -22 m, z: 0.35 m}}
      - {{name: R2, x: -14.71486 m, z: -0.10843 m}}
      - {{name: R3, x: -7.4527 m, z: -0.84635 m}}
  stinger:
    roller: r
    boxes:
      - {{name: S1, x: -0.22425 m, z: -1.86269 m}}
      - {{name: S2, x: 6.95983 m, z: -3.15592 m}}
      - {{name: S3, x: 14.08893 m, z: -4.72416 m}}
      - {{name: S4, x: 21.15253 m, z: -6.56508 m}}
      - {{name: S5, x: 28.14021 m, z: -8.67596 m}}
checks: {{limits: {{tip_clearance: 0.3 m}}}}
)",
      current);
  return read_model_text(text, "bottom_rollers.yaml").description.value();
}

}  // namespace overbend::testing
