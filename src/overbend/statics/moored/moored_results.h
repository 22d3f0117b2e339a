/// Results and warnings of a hull in equilibrium on its lines.
#pragma once

#include "base/assumption.h"
#include "base/finding.h"

#include "model/model.h"
#include "moorings/equilibrium.h"
#include "results/mooring_results.h"

namespace overbend {

/// Offset of the hull only.
VesselResult vessel_offset(const HullOffset& offset);

/// `free`: true if the hull may move; otherwise stiffness and natural periods are omitted.
MooredState moored_state(const std::string& name, const Model& model, const MooringSpread& spread,
                         const StaticHull& hull, const HullEquilibrium& rest, bool free);

/// Findings on a state, each with the name of line and stage.
Findings mooring_findings(const Model& model, const MooringSpread& spread, const MooredState& state);

/// Assumptions of the mooring analysis.
Assumptions mooring_assumptions(const Model& model);

}  // namespace overbend
