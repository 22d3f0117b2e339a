#include "results/fields/shown_unit.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace overbend
