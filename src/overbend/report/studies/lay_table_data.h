/// Curves of a lay table for the scripts of its page.
#pragma once

#include <string>

#include "base/json.h"
#include "results/lay_table_results.h"

namespace overbend {

/// Returns the label of the varied quantity with its unit: "Tension at the tensioner [kN]".
std::string lay_table_axis(const LayTable& table);

/// Returns {axis, panels: [{title, series: [{name, points: [[x, y], ...]}], limit}], least, largest} in display units;
/// rows without a lay have no points; least and largest are null if there are none.
Json lay_table_curves(const LayTable& table);

}  // namespace overbend
