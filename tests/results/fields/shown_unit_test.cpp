#include "results/fields/shown_unit.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace overbend {
namespace {

TEST(shown_unit, is_the_engineers_for_si_and_the_same_where_the_table_has_none) {
  EXPECT_EQ(shown_unit("top_tension", "N").name, "kN");
  EXPECT_DOUBLE_EQ(shown_unit("overbend_von_mises", "Pa").factor * 250e6, 250.0);
  EXPECT_EQ(shown_unit("curvature", "1/m").name, "1/m");
  EXPECT_EQ(shown_unit("curvature", "1/m").factor, 1.0);
}

TEST(shown_unit, goes_by_the_name_for_strains_dents_and_fractions_of_time) {
  EXPECT_EQ(shown_unit("sagbend_max_strain", "1").name, "%");
  EXPECT_EQ(shown_unit("design strain", "1").factor, 100.0);
  EXPECT_EQ(shown_unit("strain", "J").name, "kJ");  // an energy
  EXPECT_EQ(shown_unit("dent_depth", "m").name, "mm");
  EXPECT_EQ(text_of(shown_unit("energy_drift", "1")), "-");
}

/// A value that is printed with its unit, as it is pasted into a model file.
void expect_reads_back(const ShownUnit& unit) {
  const std::string text = unit.name.empty() ? "2 %" : "2 " + std::string(unit.name);
  const double si = unit.name.empty() ? 0.02 : 2.0 / unit.factor;
  const QuantityReading got = parse_quantity(text, unit.si == "-" ? "1" : std::string(unit.si));
  ASSERT_TRUE(got.value.has_value()) << text << ": " << got.found;
  EXPECT_NEAR(*got.value, si, 1e-14 * si) << text;  // a few roundings
}

TEST(shown_unit, every_unit_that_is_printed_is_read_back_as_the_same_value) {
  for (const ShownUnit& unit : kShownUnits) expect_reads_back(unit);
  for (const OwnUnit& own : kOwnUnits) expect_reads_back(own.unit);
  for (const char* si : {"1/m", "1/s", "Hz", "N m/rad", "N m2", "kg/m", "m/s", "m2", "m4", "m^2", "N", "N m", "J"}) {
    expect_reads_back({si, si, 1.0, 3});
  }
}

}  // namespace
}  // namespace overbend
