/// Texts and tables of a dynamic report; empty without content.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Returns the entries of the title block. `description` gives the sea and the vessel motion; without it they are
/// omitted.
std::vector<std::pair<std::string, std::string>> dynamic_entries(const StaticResults& statics,
                                                                 const DynamicResults& results,
                                                                 const std::optional<Description>& description,
                                                                 const std::string& written);
Blocks dynamic_key_results(const StaticResults& statics, const DynamicResults& results);
/// Returns statistics of the key quantities and the most probable extremes.
Blocks dynamic_statistics_section(const StaticResults& statics, const DynamicResults& results);
/// Returns the roller boxes over time.
Blocks dynamic_supports_section(const DynamicResults& results);
/// Returns the individual rollers, for the appendix.
Blocks dynamic_rollers_section(const DynamicResults& results);
Blocks impacts_section(const StaticResults& statics, const DynamicResults& results);
Blocks tensioner_section(const StaticResults& statics, const DynamicResults& results);
/// Returns the energy balance and the record of the run.
Blocks dynamic_run_section(const DynamicResults& results);

}  // namespace overbend
