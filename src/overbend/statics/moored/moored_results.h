/// Results and warnings from a hull at rest on its lines.
#pragma once

#include "base/assumption.h"
#include "base/finding.h"

#include "model/model.h"
#include "moorings/equilibrium.h"
#include "results/mooring_results.h"

namespace overbend {

/// Where the hull lies, nothing else.
VesselResult vessel_offset(const HullOffset& offset);

/// `free`: the hull may move; else stiffness and balance are left out.
MooredState moored_state(const std::string& name, const Model& model, const MooringSpread& spread,
                         const HullAtRest& hull, const RestOutcome& rest, bool free);

/// What a user should look at, each naming line and stage.
Findings mooring_findings(const Model& model, const MooringSpread& spread, const MooredState& state);

/// What the analysis takes for granted.
Assumptions mooring_assumptions(const Model& model);

}  // namespace overbend
