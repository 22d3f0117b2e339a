/// The parts of a dynamic report that are words and tables; empty where there is nothing to say.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// For the title block. `description` gives the sea and the vessel motion; without it the header omits them.
std::vector<std::pair<std::string, std::string>> dynamic_entries(const StaticResults& statics,
                                                                 const DynamicResults& results,
                                                                 const std::optional<Description>& description,
                                                                 const std::string& written);
Blocks dynamic_key_results(const StaticResults& statics, const DynamicResults& results);
/// Statistics of the key quantities and the most probable extremes.
Blocks dynamic_statistics_section(const StaticResults& statics, const DynamicResults& results);
/// Boxes over time.
Blocks dynamic_supports_section(const DynamicResults& results);
/// Rollers one by one, for the appendix.
Blocks dynamic_rollers_section(const DynamicResults& results);
Blocks impacts_section(const StaticResults& statics, const DynamicResults& results);
Blocks tensioner_section(const StaticResults& statics, const DynamicResults& results);
/// Energy balance and the course of the run.
Blocks dynamic_run_section(const DynamicResults& results);

}  // namespace overbend
