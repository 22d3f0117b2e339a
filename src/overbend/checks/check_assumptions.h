/// Assumptions of the code checks, as sentences for the report.
#pragma once

#include "base/assumption.h"
#include "checks/check_station.h"

namespace overbend {

Assumptions check_assumptions(const CheckStations& all, const CheckSettings& settings);

}  // namespace overbend
