/// The parts of the report that are words and tables. Each returns HTML; empty where there is nothing to say.
#pragma once

#include <optional>
#include <string>

#include "model/description.h"
#include "results/static_results.h"

namespace overbend {

std::string title_block(const StaticResults& results, const std::string& written);
std::string key_results(const StaticResults& results);
std::string warnings_section(const StaticResults& results);
/// Inputs as the program understood them; without a description (a model text that can not be read) what results tell.
std::string inputs_section(const StaticResults& results, const std::optional<Description>& description);
std::string assumptions_section(const StaticResults& results);
/// Stations at tensioner, supports, sagbend maximum, touchdown and anchor, in the layout of lay analyses.
std::string static_summary_table(const StaticResults& results);
std::string support_table(const StaticResults& results);
std::string roller_table(const StaticResults& results);
std::string balance_section(const StaticResults& results);
std::string model_text_section(const std::string& model_text);

}  // namespace overbend
