/// All tables of results by name, for the page and Python.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "results/dynamic_results.h"
#include "results/tables/table.h"

namespace overbend {

using NamedTables = std::vector<std::pair<std::string, Table>>;

/// Returns the tables of a static state: "summary", "boxes", "rollers", "lines", "line_ends", "moorings"; empty tables
/// are omitted.
NamedTables static_tables(const StaticResults& results);

/// Returns the tables of a run: "line_ends", "vessel", "thrust", "fairlead_tensions", "moorings", "mooring_events".
NamedTables dynamic_tables(const StaticResults& statics, const DynamicResults& results);

/// `{name: table, ...}`, see described_table_json.
Json tables_json(const NamedTables& tables);

}  // namespace overbend
