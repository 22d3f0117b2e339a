/// Directions of the components of a sea whose directions are those of a file.
#pragma once

#include <span>
#include <vector>

#include "base/random.h"
#include "model/description/waves_description.h"

namespace overbend {

struct WaveComponent;

/// Returns the azimuth from which each component comes [rad], drawn from the distribution over direction of the file at
/// the component's frequency: `waves.directions` is not empty. Between two frequencies of the file, mean directions are
/// interpolated on the circle and tables of densities linearly; the spreading is that of the nearest one. Without a
/// spreading in the file `waves.spreading` applies.
std::vector<double> component_azimuths(const WavesDescription& waves, std::span<const WaveComponent> components,
                                       Random& random);

}  // namespace overbend
