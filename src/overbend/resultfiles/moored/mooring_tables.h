/// Hull and mooring lines at rest as a table, and whether all of it are numbers.
#pragma once

#include <string>
#include <vector>

#include "results/hull_results.h"
#include "results/moored_dynamics.h"
#include "results/mooring_results.h"

namespace overbend {

/// The rest as drawn first, then the stages.
std::vector<const MooredState*> moored_states(const MooringResults& results);

/// The text of moorings.csv: a row per state and line, engineering units. `in_time`: of a dynamic analysis that began
/// at the rest, in further columns of the rest's rows.
std::string moorings_table(const MooringResults& results, const std::vector<MooringLineDynamics>& in_time = {});

/// Throw std::runtime_error that names the quantity which is no number.
void require_finite(const MooringResults& results);
void require_finite(const HullResults& hull);

}  // namespace overbend
