/// Data for the figures of moorings.
#pragma once

#include "base/json.h"
#include "report/static/mooring_scene.h"
#include "results/moored_dynamics.h"

namespace overbend {

/// Returns the states (equilibrium first, then the stages), each with the hull's offset and its lines as points in plan
/// and profile; and the surroundings. SI, frame W.
Json mooring_figure_data(const MooringResults& results, const MooringScene& scene);

/// Returns the positions of midship in a dynamic run, for the ellipses of its offset. SI.
Json vessel_figure_data(const VesselDynamics& vessel);

}  // namespace overbend
