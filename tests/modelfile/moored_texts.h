/// Model files without a pipe for the tests of the reader.
#pragma once

#include <string>

namespace overbend::testing {

/// A vessel on three lines of all sorts, in statics.
inline const std::string kMoored = R"(overbend: 1
environment:
  water_depth: 89 m
  seabed: {stiffness: 100 kN/m^2, friction: 0.3}
vessel:
  draught: 5 m
  heading: 90 deg
  hydrostatics: {heave: 36198.9 kN/m, roll: 2075448 kN*m, pitch: 42799210 kN*m}
  loads:
    - {name: pipe, at: {x: -60 m}, force: {x: -205.6 kN}}
moorings:
  types:
    wire64: {wire_rope: {diameter: 64 mm, core: wire}, bending_stiffness: 2 kN*m^2}
    chain76: {chain: {diameter: 76 mm}, friction: 0.8}
    given: {diameter: 64 mm, weight_in_air: 170 N/m, weight_submerged: 148 N/m, axial_stiffness: 1.9e5 kN, breaking_load: 2600 kN}
  winches:
    main: {speed: 0.2 m/s, haul: 700 kN, stall: 900 kN, brake: 1600 kN, drum: 1500 m}
  lines:
    - {name: port bow, fairlead: {x: 57 m, y: 15 m, z: 3 m}, bearing: 335 deg, anchor_distance: 1000 m, type: wire64, winch: main, tension: 300 kN}
    - name: starboard bow
      fairlead: {x: 57 m, y: -15 m, z: 3 m}
      azimuth: 115 deg
      anchor_distance: 1000 m
      segments: [{type: wire64, length: 700 m}, {name: chain, type: chain76, length: 310 m}]
      clumps: [{at: 900 m, mass: 5 t}]
      buoys: [{name: lifter, at: 400 m, net_buoyancy: 20 kN, mass: 1 t}]
      anchor_holding: 1500 kN
      anchor_slides: yes
    - {name: stern, fairlead: {x: -57 m, y: 0 m, z: 3 m}, anchor: {x: -1050 m, y: 20 m}, type: given, length: 1000 m, fails_at: 60 s}
  objects:
    - {name: pipeline, points: [{x: 300 m, y: -500 m, z: -88.5 m}, {x: 300 m, y: 500 m, z: -88.5 m}]}
  working_load: 900 kN
operation:
  type: moored
  stages:
    - {name: whole, loads: []}
    - {name: one parted, parted: [stern], loads: [{moment: {z: 8000 kN*m}}]}
)";

/// Lines by themselves.
inline const std::string kLines = R"(overbend: 1
environment:
  water_depth: 100 m
  seabed: {stiffness: 100 kN/m^2}
lines:
  - name: jumper
    ends:
      - {fixed: {x: -100 m, y: 0 m, z: -55 m}}
      - {fixed: {x: 0 m, y: 0 m, z: -5 m}, motion: {amplitude: {x: 10 m}, period: 27 s}}
    segments:
      - {length: 170 m, diameter: 0.396 m, mass: 165 kg/m, axial_stiffness: 500 MN, bending_stiffness: 120.8 kN*m^2}
    element: 2 m
  - name: riser
    ends: [{bed: {x: 50 m, y: 10 m}}, {water: {x: 0 m, y: 10 m, z: -20 m}, direction: {z: 1}}]
    segments:
      - {length: 120 m, chain: {diameter: 50 mm}}
)";

}  // namespace overbend::testing
