/// Direct convolution behind hull/radiation.h; include that header instead.
///
/// Memory: time since the last grid point, index of the newest velocity, then the velocities in a ring buffer.
#pragma once

#include "hull/radiation.h"

namespace overbend::convolution {

RadiationMemory make_bending_memory(const RadiationModel& model);
RadiationStep step(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v0, double h);
void advance(const RadiationModel& model, RadiationMemory& memory, const Vec6& v0, const Vec6& v1, double h);
Vec6 force(const RadiationModel& model, const RadiationMemory& memory, const Vec6& v);

}  // namespace overbend::convolution
