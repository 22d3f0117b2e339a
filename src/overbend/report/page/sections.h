/// The parts of the report that are words and tables. Each returns HTML; empty where there is nothing to say.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/assumption.h"
#include "model/description/description.h"
#include "results/dynamic_results.h"

namespace overbend {

/// Plain text, but for `control`: HTML of the document control, may be empty. `document` is its number and revision,
/// for the margins of printed pages.
std::string title_block(const std::string& kind, const std::string& title,
                        const std::vector<std::pair<std::string, std::string>>& entries,
                        const std::string& control = "", const std::string& document = "");
/// What the analysis is of, for the title block: pipe, vessel and location, or the lines.
std::vector<std::pair<std::string, std::string>> subject_entries(const StaticResults& results,
                                                                 const std::optional<Description>& description = {});
/// "converged", or "converged, 2 findings": they are further down and must not be missed.
std::string status_words(const std::string& state, std::size_t findings);
std::string key_results(const StaticResults& results, const std::string& id, const std::string& heading);
/// Inputs as read by the program; without a description (a model text that cannot be read) what results tell.
/// `dynamic`, not null for the report of a dynamic run, adds what applies only there.
std::string inputs_section(const StaticResults& results, const std::optional<Description>& description,
                           const DynamicResults* dynamic);
/// By what hangs on them.
std::string assumptions_section(const Assumptions& assumptions);
/// Stations at tensioner, supports, sagbend maximum, touchdown and anchor, in the layout of lay analyses.
std::string static_summary_table(const StaticResults& results);
/// Setting of every box and its reaction; for a dynamic run also minima and maxima. Empty in J-lay.
std::string lay_setting_section(const StaticResults& results, const std::optional<Description>& description,
                                const DynamicResults* dynamic);
std::string support_table(const StaticResults& results);
/// Rollers one by one, for the appendix.
std::string rollers_section(const StaticResults& results);
/// What is built into the pipe, and the pipe beside it; empty without any.
std::string structures_section(const StaticResults& results);
/// Clumps, buoys and wires on the pipe; empty without any.
std::string attachments_section(const StaticResults& results);
/// Contacts, free spans and extremes of the pipe on an uneven bed; empty on a plane.
std::string laid_pipe_section(const StaticResults& results);
std::string balance_section(const StaticResults& results);
std::string model_text_section(const std::string& model_text);

}  // namespace overbend
