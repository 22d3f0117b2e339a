/// The parts of the report that are words and tables; empty where there is nothing to say.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/assumption.h"
#include "model/description/description.h"
#include "report/page/blocks.h"
#include "results/dynamic_results.h"

namespace overbend {

/// What the analysis is of, for the title block: pipe, vessel and location, or the lines.
std::vector<std::pair<std::string, std::string>> subject_entries(const StaticResults& results,
                                                                 const std::optional<Description>& description = {});
/// "converged", or "converged, 2 findings": they are further down and must not be missed.
std::string status_words(const std::string& state, std::size_t findings);
Blocks key_results(const StaticResults& results, const std::string& id, const std::string& heading);
/// Inputs as read by the program; without a description (a model text that cannot be read) what results tell.
/// `dynamic`, not null for the report of a dynamic run, adds what applies only there.
Blocks inputs_section(const StaticResults& results, const std::optional<Description>& description,
                      const DynamicResults* dynamic);
/// By what hangs on them.
Blocks assumptions_section(const Assumptions& assumptions);
/// Stations at tensioner, supports, sagbend maximum, touchdown and anchor, in the layout of lay analyses.
Blocks static_summary_table(const StaticResults& results);
/// Setting of every box and its reaction; for a dynamic run also minima and maxima. Empty in J-lay.
Blocks lay_setting_section(const StaticResults& results, const std::optional<Description>& description,
                           const DynamicResults* dynamic);
Blocks support_table(const StaticResults& results);
/// Rollers one by one, for the appendix.
Blocks rollers_section(const StaticResults& results);
/// What is built into the pipe, and the pipe next to it; empty without any.
Blocks structures_section(const StaticResults& results);
/// Clumps, buoys and wires on the pipe; empty without any.
Blocks attachments_section(const StaticResults& results);
/// Contacts, free spans and extremes of the pipe on an uneven bed; empty on a plane.
Blocks laid_pipe_section(const StaticResults& results);
Blocks balance_section(const StaticResults& results);
Blocks model_text_section(const std::string& model_text);

}  // namespace overbend
