#include "results/tables/mooring_tables.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace overbend {
namespace {

MooringLineResult line_named(const char* name) {
  MooringLineResult line;
  line.name = name;
  return line;
}

std::vector<std::string> keys(const Table& table) {
  std::vector<std::string> all;
  for (const TableColumn& column : table.columns) all.push_back(column.key);
  return all;
}

TEST(mooring_tables, at_rest_have_the_columns_that_the_fields_of_a_line_describe) {
  MooringLineResult line = line_named("S1");
  line.fairlead_tension = 346'612.0;
  line.utilisation = 1.02;
  const Table table = moorings_at_rest({line});
  EXPECT_EQ(table_text(table.with_columns({"name", "fairlead_tension", "utilisation"})),
            "  Line  Tension kN  Utilisation\n"
            "  S1         346.6        1.020\n");
  EXPECT_EQ(table.rows[0].mark, RowMark::over);
  const auto tension = std::ranges::find(table.columns, "fairlead_tension", &TableColumn::key);
  EXPECT_EQ(tension->description, "Tension at the fairlead");
}

TEST(mooring_tables, leave_out_what_no_line_has) {
  MooringLineResult parted = line_named("S2");
  parted.parted = true;
  const std::vector<std::string> all = keys(moorings_at_rest({line_named("S1"), parted}));
  for (const char* absent : {"utilisation", "anchor_utilisation", "clearance"}) {
    EXPECT_EQ(std::ranges::count(all, absent), 0) << absent;
  }
}

TEST(mooring_tables, say_of_a_parted_line_that_it_is_and_nothing_else_but_its_length) {
  MooringLineResult line = line_named("S1");
  line.length = 1000.0;
  line.parted = true;
  const Table table = moorings_at_rest({line});
  EXPECT_EQ(table.rows[0].mark, RowMark::soft);
  EXPECT_EQ(table_text(table.with_columns({"name", "length", "fairlead_tension", "remark"})),
            "  Line  Length m  Tension kN\n"
            "  S1     1000.00           -  parted\n");
}

TEST(mooring_tables, events_stand_in_the_order_of_time) {
  MooringLineDynamics first, second;
  first.name = "S1";
  first.events = {{30.0, "parts"}};
  second.name = "S2";
  second.events = {{10.0, "goes slack"}};
  EXPECT_EQ(table_text(mooring_events({first, second})),
            "  Time s  Line  Event\n"
            "    10.0  S2    goes slack\n"
            "    30.0  S1    parts\n");
}

}  // namespace
}  // namespace overbend
