#include "report/moored/hull_section.h"

#include <gtest/gtest.h>

#include "report/synthetic_moorings.h"

namespace overbend {
namespace {

using testing::synthetic_hull;

TEST(hull_section, tells_the_parts_of_the_damping_in_percent_and_their_sum) {
  const std::string section = hull_section(synthetic_hull());
  EXPECT_NE(section.find("<td class=\"t\">sway</td><td>77.10</td><td>4540</td><td>0.02</td><td>0.02</td><td>3.20</td>"
                         "<td>11.50</td><td>0.00</td><td>14.72</td>"),
            std::string::npos)
      << section;
  EXPECT_EQ(section.find("Positioning"), std::string::npos);
}

TEST(hull_section, marks_a_mode_that_is_excited_instead_of_damped) {
  HullResults hull = synthetic_hull();
  hull.damping[2].total = -0.004;
  EXPECT_NE(hull_section(hull).find("<tr class=\"over\"><td class=\"t\">yaw</td>"), std::string::npos);
}

TEST(hull_section, shows_what_the_uncertain_drag_coefficient_decides_of_the_current) {
  const std::string section = hull_section(synthetic_hull());
  for (const char* force : {"<td>146.0</td>", "<td>265.3</td>", "<td>398.0</td>"}) {
    EXPECT_NE(section.find(force), std::string::npos) << force;
  }
  HullResults table = synthetic_hull();
  table.current_least = table.current_most = 0.0;
  EXPECT_EQ(hull_section(table).find("drag coefficient decides"), std::string::npos);
}

TEST(hull_section, has_the_fit_entry_by_entry_and_the_least_eigenvalue_of_each_group) {
  const std::string section = hull_section(synthetic_hull());
  EXPECT_NE(section.find("<td class=\"t\">surge, pitch</td><td class=\"t\">state space</td><td>16</td><td>-1.2e-07</td>"
                         "<td>0.030</td><td>none</td>"),
            std::string::npos)
      << section;
  EXPECT_NE(section.find("<td class=\"t\">surge</td><td>0.40</td><td>0.60</td><td>800</td><td>807</td><td>0.88</td>"),
            std::string::npos)
      << section;
  EXPECT_NE(section.find("0.400 % above"), std::string::npos);
}

}  // namespace
}  // namespace overbend
