/// Direct convolution behind hull/radiation.h, which is what to include.
///
/// Memory: time since the last point of the grid, index of the newest velocity, then the velocities in a ring.
#pragma once

#include "hull/radiation.h"

namespace overbend::convolution {

RadiationMemory fresh_memory(const RadiationModel& model);
RadiationStep step(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v0, double h);
void advance(const RadiationModel& model, RadiationMemory& memory, const Vec6& v0, const Vec6& v1, double h);
Vec6 force(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v);

}  // namespace overbend::convolution
