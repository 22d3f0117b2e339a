#include "report/moored/hull_section.h"

#include <gtest/gtest.h>

#include "report/page_text.h"
#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::shown_text;
using testing::synthetic_hull;

TEST(hull_section, shows_the_parts_of_the_damping_in_percent_and_their_sum) {
  const std::string section = shown_text(hull_section(synthetic_hull()));
  EXPECT_NE(section.find("\nsway | 77.10 | 4540 | 0.02 | 0.02 | 3.20 | 11.50 | 0.00 | 14.72\n"), std::string::npos)
      << section;
  EXPECT_EQ(section.find("Positioning"), std::string::npos);
}

TEST(hull_section, marks_a_mode_that_is_excited_instead_of_damped) {
  HullResults hull = synthetic_hull();
  hull.damping[2].total = -0.004;
  EXPECT_NE(shown_text(hull_section(hull)).find("\nover: yaw |"), std::string::npos);
}

TEST(hull_section, shows_what_the_uncertain_drag_coefficient_decides_of_the_current) {
  const std::string section = shown_text(hull_section(synthetic_hull()));
  for (const char* force : {" | 146.0\n", "total: as in the model | 265.3\n", " | 398.0\n"}) {
    EXPECT_NE(section.find(force), std::string::npos) << force;
  }
  HullResults table = synthetic_hull();
  table.min_current_force = table.max_current_force = 0.0;
  EXPECT_EQ(shown_text(hull_section(table)).find("effect of the drag coefficient"), std::string::npos);
}

TEST(hull_section, has_the_fit_entry_by_entry_and_the_least_eigenvalue_of_each_group) {
  const std::string section = shown_text(hull_section(synthetic_hull()));
  EXPECT_NE(section.find("\nsurge, pitch | state space | 16 | -1.2e-07 | 0.030 | none\n"), std::string::npos)
      << section;
  EXPECT_NE(section.find("\nsurge | 0.40 | 0.60 | 800 | 807 | 0.88 |"), std::string::npos) << section;
  EXPECT_NE(section.find("at [rad/s]"), std::string::npos);
  EXPECT_NE(section.find("0.400 % above"), std::string::npos);
}

}  // namespace
}  // namespace overbend
