/// The code checks of a report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "results/static_results.h"

namespace overbend {

/// Governing checks first, then every check by region, the utilisation along the pipe, and the numbers that went in.
/// HTML; empty for results without checks. `number` counts the figures.
std::string checks_section(const StaticResults& statics, const CheckTable& table, int& number);

/// What the figure of the utilisations draws.
nlohmann::json checks_figure_data(const StaticResults& statics, const CheckTable& table);

}  // namespace overbend
