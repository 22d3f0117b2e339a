/// The code checks of a report.
#pragma once

#include <string>

#include "base/json.h"
#include "results/static_results.h"

namespace overbend {

/// Governing checks first, the utilisation along the pipe, then every check by region. HTML; empty for results without
/// checks. `number` counts the figures.
std::string checks_section(const StaticResults& statics, const CheckTable& table, int& number);

/// The numbers that went into each check, for the appendix.
std::string check_inputs_section(const CheckTable& table);

/// Data of the utilisation figure.
Json checks_figure_data(const StaticResults& statics, const CheckTable& table);

}  // namespace overbend
