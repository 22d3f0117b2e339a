/// The table of checks as text: for spreadsheets and for scripts.
#pragma once

#include <string>

#include "resultfiles/seeds_writer.h"
#include "resultfiles/summary_json.h"
#include "results/check_results.h"

namespace overbend {

/// What people read demand and capacity of a check in: kN, kN m, MPa, kN/m; a strain in %.
TableUnit check_unit(const CheckRow& row);

/// The same for a number that went in; lengths, which are those of a section, in mm.
TableUnit check_unit(const CheckInput& input);

/// The text of checks.csv: a row per check, the units of the other tables beside demand and capacity.
std::string checks_table(const CheckTable& table);

/// What a check is and how it came out, without numbers.
Json check_head_json(const CheckRow& row);

/// The key `checks` of summary.json.
Json checks_json(const CheckTable& table);

}  // namespace overbend
