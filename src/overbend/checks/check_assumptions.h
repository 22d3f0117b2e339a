/// Assumptions of the checks, in words for the report.
#pragma once

#include "base/assumption.h"
#include "checks/check_station.h"

namespace overbend {

Assumptions check_assumptions(const CheckStations& all, const CheckSettings& settings);

}  // namespace overbend
