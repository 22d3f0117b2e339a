/// Texts and tables of the report; empty without content.
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

/// Returns the subject of the analysis for the title block: pipe, vessel and location, or the lines.
std::vector<std::pair<std::string, std::string>> subject_entries(const StaticResults& results,
                                                                 const std::optional<Description>& description = {});
/// Returns "converged", or "converged, 2 findings": they are listed further down and must not be missed.
std::string status_label(const std::string& state, std::size_t findings);
Blocks key_results(const StaticResults& results, const std::string& id, const std::string& heading);
/// Returns the inputs as read by the program; without a description (a model text that cannot be read) those contained
/// in the results. `dynamic`, not null for the report of a dynamic run, adds the inputs used only there.
Blocks inputs_section(const StaticResults& results, const std::optional<Description>& description,
                      const DynamicResults* dynamic);
/// Returns the assumptions, ordered by their influence.
Blocks assumptions_section(const Assumptions& assumptions);
/// Returns the stations at tensioner, supports, sagbend maximum, touchdown and anchor, in the usual layout of lay
/// analyses.
Blocks static_summary_table(const StaticResults& results);
/// Returns the setting of every box and its reaction; for a dynamic run also minima and maxima. Empty in J-lay.
Blocks lay_setting_section(const StaticResults& results, const std::optional<Description>& description,
                           const DynamicResults* dynamic);
Blocks support_table(const StaticResults& results);
/// Returns the individual rollers, for the appendix.
Blocks rollers_section(const StaticResults& results);
/// Returns the structures built into the pipe, and the pipe next to them; empty without any.
Blocks structures_section(const StaticResults& results);
/// Returns clumps, buoys and wires on the pipe; empty without any.
Blocks attachments_section(const StaticResults& results);
/// Returns contacts, free spans and extremes of the pipe on an uneven seabed; empty on a plane seabed.
Blocks laid_pipe_section(const StaticResults& results);
Blocks balance_section(const StaticResults& results);
Blocks model_text_section(const std::string& model_text);

}  // namespace overbend
