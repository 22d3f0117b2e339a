/// The report of what has no pipe: a hull on its mooring lines, lines by themselves.
#pragma once

#include <string>

#include "results/dynamic_results.h"
#include "results/static_results.h"

namespace overbend {

/// The whole page, as report_html() of report/report.h.
std::string report_without_pipe(const StaticResults& results, const std::string& model_text);
std::string report_without_pipe(const StaticResults& statics, const DynamicResults& results,
                                const std::string& model_text);

}  // namespace overbend
