/// The sea as a sum of harmonic wave components.
#pragma once

#include <vector>

#include "model/description.h"

namespace overbend {

/// Elevation a cos(kx x + ky y - omega t + phase).
struct WaveComponent {
  double amplitude = 0.0, omega = 0.0, wave_number = 0.0, kx = 0.0, ky = 0.0, phase = 0.0;
};

struct Sea {
  WaveType type = WaveType::none;
  double depth = 0.0;
  std::vector<WaveComponent> components;
  bool calm() const { return components.empty(); }
};

}  // namespace overbend
