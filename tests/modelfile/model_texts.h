/// Model files for the tests of the reader: one that uses every part of the format, and ways to spoil it.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "support/solved_case.h"

namespace overbend::testing {

/// A valid model whose parts the bad corpus spoils one at a time.
inline const std::string kGoodModel = R"(overbend: 1
title: a good model

environment:
  water_depth: 89 m
  water_weight_density: 10.05 kN/m^3
  seabed:
    stiffness: 100 kN/m^2
    friction: {axial: 0.5, lateral: 0.6}
  current:
    - {depth: 0 m, speed: 1.02 m/s, towards: 0 deg}
    - {depth: 20 m, speed: 0.5 m/s, towards: 90 deg}
  waves: {type: jonswap, hs: 4 m, tp: 12.9 s, from: 180 deg, seed: 7}

pipe:
  steel:
    outside_diameter: 16 in
    wall_thickness: 11.125 mm
    poissons_ratio: 0.3
    yield_stress: 414 MPa
  coatings:
    - {name: corrosion coating, thickness: 3.2 mm, weight_density: 9.32 kN/m^3}
    - {name: concrete, thickness: 38.1 mm, weight_density: 21.974 kN/m^3}
  joint: {length: 12 m, field_joint: 0.6 m, infill_weight_density: 10.065 kN/m^3}
  hydrodynamics: {drag_normal: 1.2}
  segments:
    - {name: thick end, length: 24 m, steel: {wall_thickness: 20 mm}}

vessel:
  depth: 9 m
  draught: 5 m
  heading: 90 deg
  stern_shoe: {x: -60 m, z: 3.8 m}
  motion: {harmonic: {heave: {amplitude: 1 m, period: 8 s, phase: 30 deg}, pitch: {amplitude: 2 deg, period: 9 s}}}

tensioner:
  x: -48.9 m
  z: 1.404 m
  tension: 250 kN
  range: [240 kN, 260 kN]
  delay: 2 s
  velocity: 0.25 m/s

rollers:
  v:
    bottom: {radius: 0.15 m, face: 0.6 m}
    sides: {radius: 0.15 m, face: 0.6 m, angle: 60 deg, clearance: 0.05 m}
    stiffness: 1e6 kN/m
    friction: 0.1
  flat:
    bottom: {radius: 0.2 m, face: 1 m}

supports:
  ramp:
    roller: v
    rows: 3
    boxes:
      - {name: ramp 1, x: -39 m, z: 1.1 m, length: 3 m}
      - {name: ramp 2, x: -9 m, z: -1.2 m, length: 3 m, rows: 2}
  stinger:
    roller: flat
    boxes:
      - {name: tip, x: 5.23 m, z: -4.5 m, offset: 10 mm, roller: v, incline: 12 deg}
      - {x: 9 m, z: -5.7 m}

analysis:
  static: {method: newton, tolerance: 1e-8}
  dynamic: {duration: 3 h, max_step: 0.1 s, seeds: [3, 4]}
)";

/// One way to spoil the good model: replace `find` (first occurrence) by `replace`; the complaint must name the line on
/// which `line_text` stands in the spoilt text, the key, and the words.
struct Spoiling {
  const char* claim;
  std::string find, replace;
  std::string line_text;      ///< Empty = the line of `replace`.
  std::string key;            ///< Full path; empty = the file itself.
  std::string expected_text;  ///< Part of the message.
  bool schema_sees;           ///< A JSON Schema can judge this too.
};

inline std::string spoil(const Spoiling& s) {
  std::string text = kGoodModel;
  const std::size_t index = text.find(s.find);
  return index == std::string::npos ? std::string() : text.replace(index, s.find.size(), s.replace);
}

inline int find_line_number(const std::string& text, const std::string& part) {
  int line = 1;
  for (std::size_t i = 0, end = text.find(part); i < end; ++i) line += text[i] == '\n' ? 1 : 0;
  return line;
}

/// Every class of error.
const std::vector<Spoiling>& bad_corpus();

/// The examples and the reference cases of the repository.
inline std::vector<std::filesystem::path> good_files() {
  std::vector<std::filesystem::path> files;
  for (const char* folder :
       {"examples", "validation/static_cases", "validation/mooring_cases", "validation/operation_cases"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(OVERBEND_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".yaml") files.push_back(entry.path());
    }
  }
  return files;
}

}  // namespace overbend::testing
