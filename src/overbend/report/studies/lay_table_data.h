/// Curves of a lay table for the scripts of its page.
#pragma once

#include <string>

#include "base/json.h"
#include "results/lay_table_results.h"

namespace overbend {

/// What the rows are over, in words with the unit: "Tension at the tensioner [kN]".
std::string lay_table_axis(const LayTable& table);

/// {axis, panels: [{title, series: [{name, points: [[x, y], ...]}], limit}], least, largest} in shown units; points of
/// rows without a lay are left out, least and largest are null where there are none.
Json lay_table_curves(const LayTable& table);

}  // namespace overbend
