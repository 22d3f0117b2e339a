/// Load effect factors of DNV-ST-F101, see load_effects.h: plain numbers, usable in kernels.
#pragma once

namespace overbend {

/// gamma_F gamma_C and gamma_E, each for an unfavourable and for a favourable load effect.
struct LoadFactors {
  double functional = 1.1, functional_favourable = 1.0 / 1.1;
  double environmental = 1.3, environmental_favourable = 1.0 / 1.3;
};

}  // namespace overbend
