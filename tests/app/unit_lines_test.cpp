#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "app/print_checks.h"
#include "app/print_friction.h"
#include "app/print_moorings.h"
#include "app/print_stages.h"
#include "app/print_stinger.h"
#include "report/synthetic_dynamics.h"
#include "report/synthetic_moorings.h"
#include "report/synthetic_operation.h"
#include "support/us_units.h"

namespace overbend {
namespace {

void expect_us(const std::string& text) {
  static const std::regex kMetric(R"(\d ?(kN|MPa|mm|m)\b.*| (kN|MPa|kNm|m/s)\b.*|[a-z] m\b.*)");
  std::smatch found;
  EXPECT_FALSE(std::regex_search(text, found, kMetric)) << found.str();
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(unit_lines, of_moorings_and_stages_are_customary_where_that_is_asked_for) {
  MooringResults moored = testing::synthetic_stages();
  DynamicResults moved;
  testing::add_moored_dynamics(moved);
  const OperationResults operation = testing::synthetic_abandonment();
  const double tension = moored.rest.moorings.front().fairlead_tension;
  const UsUnits units;
  const std::string text = moored_state_lines(moored);
  expect_us(text);
  EXPECT_TRUE(has(text, fmt::format("{:.2f}", tension / 4448.2216152605)));
  EXPECT_TRUE(has(text, "Tension kip"));
  EXPECT_TRUE(has(text, " parted\n")) << text;
  expect_us(moored_dynamics_lines(moved));
  const std::string heads = stage_heads(OperationType::abandonment);
  expect_us(heads);
  EXPECT_TRUE(has(heads, "ksi"));
  for (const StageResult& stage : operation.stages) {
    if (stage.lay) expect_us(stage_line(stage));
  }
}

TEST(unit_lines, of_friction_stinger_and_checks_are_customary_where_that_is_asked_for) {
  StaticResults results;
  results.route = RouteResults{};
  results.route->laid_offset = 0.3048;
  results.route->radius = 304.8;
  results.roller_friction = {{}};
  results.roller_friction.front().bottom_tension = 4448.2216152605;
  StingerSectionResult section;
  section.floats = true;
  section.hinge_force = 44482.216152605;
  results.stinger = {section};
  const UsUnits units;
  const std::string text = friction_lines(results) + stinger_lines(results);
  expect_us(text);
  EXPECT_TRUE(has(text, "1.00 ft to port"));
  EXPECT_TRUE(has(text, "1000 ft; friction holds a radius of 0 ft or more"));
  EXPECT_TRUE(has(text, "1.000 kip bottom"));
  EXPECT_TRUE(has(text, "hinge force 10.00 kip"));
}

}  // namespace
}  // namespace overbend
