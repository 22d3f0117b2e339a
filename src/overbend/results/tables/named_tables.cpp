#include "results/tables/named_tables.h"

#include "results/tables/line_tables.h"
#include "results/tables/mooring_tables.h"
#include "results/tables/support_tables.h"

namespace overbend {
namespace {

NamedTables with_rows(NamedTables tables) {
  std::erase_if(tables, [](const auto& table) { return table.second.empty(); });
  return tables;
}

}  // namespace

NamedTables static_tables(const StaticResults& results) {
  NamedTables tables;
  if (results.has_pipe()) tables.emplace_back("summary", station_summary(results));
  tables.emplace_back("boxes", roller_boxes(results));
  tables.emplace_back("rollers", single_rollers(results));
  tables.emplace_back("lines", lines_at_rest(results.lines));
  tables.emplace_back("line_ends", line_ends(results.lines, {}));
  if (results.moorings) tables.emplace_back("moorings", moorings_at_rest(results.moorings->rest.moorings));
  return with_rows(std::move(tables));
}

NamedTables dynamic_tables(const StaticResults& statics, const DynamicResults& results) {
  NamedTables tables;
  if (!results.lines.empty()) tables.emplace_back("line_ends", line_ends(statics.lines, results.lines));
  if (results.vessel) tables.emplace_back("vessel", vessel_motions(*results.vessel, course(results)));
  tables.emplace_back("thrust", thrust_over_time(results.thrust));
  tables.emplace_back("fairlead_tensions", fairlead_tensions(results.moorings));
  tables.emplace_back("moorings", moorings_over_time(results.moorings));
  tables.emplace_back("mooring_events", mooring_events(results.moorings));
  return with_rows(std::move(tables));
}

Json tables_json(const NamedTables& tables) {
  Json json = Json::object();
  for (const auto& [name, table] : tables) json[name] = described_table_json(table);
  return json;
}

}  // namespace overbend
