/// The report of a hull on its mooring lines in time, without a pipe.
#pragma once

#include <string>

#include "results/dynamic_results.h"

namespace overbend {

/// The whole page, as report_html() of report/report.h. `statics`: those of a hull alone.
std::string moored_report_in_time(const StaticResults& statics, const DynamicResults& results,
                                  const std::string& model_text);

}  // namespace overbend
