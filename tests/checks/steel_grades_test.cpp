#include "checks/steel_grades.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(steel_grades, yield_stresses_of_both_series_find_their_grade) {
  EXPECT_STREQ(find_grade(414e6)->name, "X60");
  EXPECT_DOUBLE_EQ(find_grade(414e6)->tensile_strength, 517e6);
  EXPECT_STREQ(find_grade(415e6)->name, "X60");
  EXPECT_DOUBLE_EQ(find_grade(415e6)->tensile_strength, 520e6);
  EXPECT_STREQ(find_grade(450e6)->name, "X65");
  EXPECT_STREQ(find_grade(482.6e6)->name, "X70");  // 70 ksi
}

TEST(steel_grades, a_yield_stress_between_grades_has_none) {
  EXPECT_FALSE(find_grade(430e6));
  EXPECT_FALSE(find_grade(100e6));
  EXPECT_FALSE(find_grade(900e6));
}

TEST(steel_grades, laying_limits_are_the_tables_and_never_interpolated) {
  EXPECT_DOUBLE_EQ(laying_limits(414e6)->static_strain, 0.0023);
  EXPECT_DOUBLE_EQ(laying_limits(414e6)->combined_strain, 0.0029);
  EXPECT_DOUBLE_EQ(laying_limits(450e6)->static_strain, 0.0025);
  EXPECT_DOUBLE_EQ(laying_limits(450e6)->combined_strain, 0.00305);
  EXPECT_DOUBLE_EQ(laying_limits(485e6)->static_strain, 0.0027);
  EXPECT_DOUBLE_EQ(laying_limits(485e6)->combined_strain, 0.00325);
  EXPECT_STREQ(laying_limits(430e6)->grade, "X60");  // the nearest lower one
  EXPECT_STREQ(laying_limits(700e6)->grade, "X70");
  EXPECT_FALSE(laying_limits(290e6));
}

TEST(steel_grades, a_grade_without_a_row_has_no_limits) {
  EXPECT_DOUBLE_EQ(find_grade_limits("X52")->static_strain, 0.00205);
  EXPECT_FALSE(find_grade_limits("X56"));
}

}  // namespace
}  // namespace overbend
