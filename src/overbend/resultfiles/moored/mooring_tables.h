/// Table of the static results of hull and mooring lines, and the check for finite numbers.
#pragma once

#include <string>
#include <vector>

#include "results/hull_results.h"
#include "results/moored_dynamics.h"
#include "results/mooring_results.h"

namespace overbend {

/// Returns the equilibrium in the nominal configuration first, then the stages.
std::vector<const MooredState*> moored_states(const MooringResults& results);

/// Returns the text of moorings.csv: a row per state and line, engineering units. `in_time`: results of a dynamic
/// analysis from the equilibrium, in further columns of its rows.
std::string moorings_table(const MooringResults& results, const std::vector<MooringLineDynamics>& in_time = {});

/// Throw std::runtime_error that names the first quantity that is not finite.
void require_finite(const MooringResults& results);
void require_finite(const HullResults& hull);

}  // namespace overbend
