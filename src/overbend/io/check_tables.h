/// The table of checks as text: for spreadsheets and for scripts.
#pragma once

#include <string>

#include "io/summary_json.h"
#include "results/check_results.h"

namespace overbend {

/// The text of checks.csv: a row per check, SI units beside demand and capacity.
std::string checks_table(const CheckTable& table);

/// What a check is and how it came out, without numbers.
Json check_head_json(const CheckRow& row);

/// The key `checks` of summary.json.
Json checks_json(const CheckTable& table);

}  // namespace overbend
