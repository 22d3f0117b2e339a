#include "seafiles/motion_history_reader.h"

#include <gtest/gtest.h>

#include "base/constants.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using testing::WrittenFile;

TEST(motion_history_reader, columns_stand_in_any_order_and_missing_ones_are_zero) {
  const WrittenFile file("motion.csv", "# measured\npitch_deg,time_s,heave_m\n1,0,0.5\r\n-2,0.5,0.25\n\n3,1.5,0\n");
  Diagnostics diagnostics;
  const auto history = read_motion_history(file.path(), 0.0, diagnostics);
  ASSERT_TRUE(history.has_value()) << diagnostics.lines(Severity::error)[0];
  EXPECT_EQ(history->time, (std::vector<double>{0.0, 0.5, 1.5}));
  EXPECT_EQ(history->freedoms[1], (std::array<double, 6>{0.0, 0.0, 0.25, 0.0, -2.0 * kDegree, 0.0}));
}

TEST(motion_history_reader, a_hole_in_a_record_is_warned_of) {
  std::string text = "time_s,heave_m\n";
  for (int i = 0; i < 120; ++i) {
    if (i < 30 || i > 70) text += std::to_string(0.5 * i) + "," + std::to_string(0.01 * i) + "\n";
  }
  const WrittenFile file("motion.csv", text);
  Diagnostics diagnostics;
  ASSERT_TRUE(read_motion_history(file.path(), 0.0, diagnostics));
  const std::vector<std::string> warnings = diagnostics.lines(Severity::warning);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("a gap of 21 s"), std::string::npos) << warnings[0];
}

TEST(motion_history_reader, errors_are_reported_with_file_line_what_was_found_and_what_was_expected) {
  struct BadInput {
    std::string text;
    int line;
    const char* expected_text;
  };
  const std::vector<BadInput> errors = {
      {"", 0, "no rows"},
      {"time_s,heave\n0,1\n", 1, "a column without a unit: heave"},
      {"time_s,wind\n0,1\n", 1, "a column 'wind', expected one of time_s, surge_m"},
      {"heave_m\n1\n", 1, "without time_s"},
      {"time_s,heave_m,heave_m\n0,1,1\n", 1, "twice"},
      {"time_s,heave_m\n0,1\n1,x\n", 3, "'x', expected a number for heave_m"},
      {"time_s,heave_m\n0,1\n1,inf\n", 3, "'inf'"},
      {"time_s,heave_m\n0,1\n1\n", 3, "1 cells, expected 2"},
      {"time_s,heave_m\n1,1\n1,2\n", 3, "a later time than in the previous row"},
      {"time_s,heave_m\n0,1\n", 2, "at least two"},
      {"time,heave_m\n0,1\n1,1\n", 2, "a time of '0' without a unit"},
      {"time_s,heave_deg\n0,1\n1,1\n", 1, "the unit 'deg' of heave_deg"},
      {"time_s,heave_m\ns,cm\n0,1\n1,1\n", 1, "two units of heave_m: m and cm"},
      {"time,heave_m\n59:40.5,1\n59:41.0,1\n", 2, "with hours, minutes and seconds"},
      {"time,heave_m\n06/01/2026 09:00:00,1\n", 2, "write the year first"},
  };
  for (const BadInput& damage : errors) {
    const WrittenFile file("motion.csv", damage.text);
    Diagnostics diagnostics;
    EXPECT_FALSE(read_motion_history(file.path(), 0.0, diagnostics).has_value());
    ASSERT_EQ(diagnostics.error_count(), 1) << damage.expected_text;
    const Diagnostic first = diagnostics.sorted().front();
    EXPECT_EQ(first.line, damage.line) << render(first);
    EXPECT_NE(render(first).find(damage.expected_text), std::string::npos) << render(first);
  }
}

}  // namespace
}  // namespace overbend
