/// A 42-inch concrete-coated pipe in 12 m of water: so stiff that shear has a percent of its pull at touchdown.
#pragma once

#include "modelfile/reading/yaml_reader.h"

namespace overbend::testing {

inline Description stiff_pipe() {
  return read_model_text(R"(overbend: 1
environment: {water_depth: 12 m, seabed: {stiffness: 100 kN/m^2}}
pipe:
  steel: {outside_diameter: 1066.8 mm, wall_thickness: 25.4 mm, yield_stress: 450 MPa}
  coatings: [{name: concrete, thickness: 100 mm, weight_density: 30 kN/m^3}]
vessel: {stern_shoe: {x: -60 m, z: 0 m}, motion: fixed}
tensioner: {x: 0 m, z: 0 m, guide: pinned, tension: 300 kN}
)",
                         "stiff.yaml")
      .description.value();
}

}  // namespace overbend::testing
