/// Assumptions of the checks, in words for the report.
#pragma once

#include <string>
#include <vector>

#include "checks/check_station.h"

namespace overbend {

std::vector<std::string> check_assumptions(const CheckStations& all, const CheckSettings& settings);

}  // namespace overbend
