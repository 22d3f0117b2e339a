/// Load effect factors of DNV-ST-F101, see load_effects.h: numbers alone, for kernels too.
#pragma once

namespace overbend {

/// gamma_F gamma_C and gamma_E, each with the value for a load effect that acts unfavourably and the one for a
/// favourable load effect.
struct LoadFactors {
  double functional = 1.1, functional_favourable = 1.0 / 1.1;
  double environmental = 1.3, environmental_favourable = 1.0 / 1.3;
};

}  // namespace overbend
