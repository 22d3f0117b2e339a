/// Hydrodynamic files in the repository and the radiation made from them once for all tests.
#pragma once

#include <string>

#include "hull/make_radiation.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::testing {

inline HydrodynamicData read_repository_data(const std::string& stem, double water_density) {
  HydrodynamicsSource source;
  source.path = std::string(OVERBEND_SOURCE_DIR) + "/" + stem;
  source.water_density = water_density;
  Diagnostics diagnostics;
  return read_hydrodynamics(source, diagnostics).value();
}

/// The barge of data/bgl1, about its centre of gravity.
inline const HydrodynamicData& bgl1_data() {
  static const HydrodynamicData data = read_repository_data("data/bgl1/bgl1", 1025.0);
  return data;
}

/// The floating sphere of validation/sphere, radius 5 m in water of 1000 kg/m3.
inline const HydrodynamicData& sphere_data() {
  static const HydrodynamicData data = read_repository_data("validation/sphere/sphere", 1000.0);
  return data;
}

inline const Radiated& bgl1_radiation(Radiation kind) {
  static const Radiated fitted = make_radiation(bgl1_data(), Radiation::state_space);
  static const Radiated direct = make_radiation(bgl1_data(), Radiation::convolution);
  return kind == Radiation::convolution ? direct : fitted;
}

}  // namespace overbend::testing
