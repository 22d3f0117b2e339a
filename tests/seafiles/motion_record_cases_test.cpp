// Recorded motions as instruments and spreadsheets export them.
#include <gtest/gtest.h>

#include "base/constants.h"
#include "seafiles/motion_history_reader.h"
#include "support/rao_files.h"
#include "support/table_cases.h"

namespace overbend {
namespace {

/// Values of degrees of freedom, in m and deg, at 0, 12 and 30 s.
using Values = std::map<std::size_t, std::array<double, 3>>;

constexpr std::array<double, 3> kHeave = {0.0709, 0.0775, -0.529}, kRoll = {0.6231, 1.5407, -0.7637},
                                kPitch = {-0.266, -0.6116, 0.6116}, kSurge = {0.0, 0.2165, 0.2165},
                                kYaw = {0.0, 0.5211, -0.161};

std::string expect_record(const std::string& name, const Values& values, const MotionColumns& columns = {}) {
  Diagnostics diagnostics;
  const auto history = read_motion_history(testing::table_case("records/" + name), 0.0, diagnostics, columns);
  const std::string messages = testing::all_messages(diagnostics);
  EXPECT_TRUE(history) << messages;
  if (!history || history->time.size() != 121U) {
    ADD_FAILURE() << name << messages;
    return messages;
  }
  EXPECT_EQ(history->time.front(), 0.0);
  EXPECT_NEAR(history->time.back(), 60.0, 1e-6);
  constexpr std::array<std::size_t, 3> kRows = {0, 24, 60};
  constexpr std::array<double, 3> kTimes = {0.0, 12.0, 30.0};
  for (const auto& [freedom, expected] : values) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t row = kRows[i];
      EXPECT_NEAR(history->time[row], kTimes[i], 1e-6);
      const double value = history->freedoms[row][freedom];
      EXPECT_NEAR(freedom > 2 ? value * kToDegrees : value, expected[i], 6e-5) << name << " " << freedom << " " << row;
    }
  }
  return messages;
}

std::string reading_error(const std::string& file, const MotionColumns& columns = {}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_motion_history(file, 0.0, diagnostics, columns));
  const std::vector<std::string> errors = diagnostics.lines(Severity::error);
  return errors.empty() ? "" : errors.front();
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

TEST(motion_record_cases, clock_times_pass_midnight) {
  const std::string messages = expect_record("clock-midnight.csv", {{2, kHeave}, {3, kRoll}, {4, kPitch}});
  expect_part(messages, "clock times, 23:59:40.000 to 00:00:40.000 of the next day; t = 0 is the first row");
}

TEST(motion_record_cases, unix_times_with_columns_named_by_keys) {
  const std::string messages = expect_record(
      "unix.csv", {{0, kSurge}, {2, kHeave}, {3, kRoll}},
      {{"timestamp", "time (Unix, s)"}, {"surge", "surge_m"}, {"heave", "heave_m"}, {"roll", "roll_rad"}});
  expect_part(messages, "Unix times from 2026-06-01 08:00:00 UTC");
  expect_part(messages, "roll is converted from rad to deg");
  expect_part(reading_error(testing::table_case("records/unix.csv")), "columns without a unit: surge, heave and roll");
}

TEST(motion_record_cases, milliseconds_with_a_line_of_units) {
  const std::string messages = expect_record("milliseconds.tsv", {{2, kHeave}, {4, kPitch}});
  expect_part(messages, "times from 125000 ms; t = 0 is the first row");
}

TEST(motion_record_cases, semicolons_with_decimal_commas_and_other_names) {
  expect_record("semicolon-decimal-comma.csv", {{2, kHeave}, {3, kRoll}, {4, kPitch}},
                {{"Zeit", "time"}, {"Tauchen", "heave"}, {"Rollen", "roll"}, {"Stampfen", "pitch"}});
  expect_part(reading_error(testing::table_case("records/semicolon-decimal-comma.csv")),
              "a column 'Zeit [s]' for 'zeit'");
}

TEST(motion_record_cases, quoted_cells_and_commas_at_the_end_of_lines) {
  expect_record("quoted.csv", {{2, kHeave}, {3, kRoll}});
}

TEST(motion_record_cases, dates_with_times_and_a_yaw_that_passes_north) {
  const std::string messages = expect_record("iso-times.csv", {{2, kHeave}, {4, kPitch}, {5, kYaw}});
  expect_part(messages, "dates with times, 2026-06-01T09:00:00.000Z to");
}

TEST(motion_record_cases, damaged_files_are_rejected_with_their_line) {
  const std::string back = reading_error(testing::table_case("bad/clock-back.csv"));
  expect_part(back, "clock-back.csv:14: found 09:00:12 after 10:00:01");
  expect_part(back, "daylight saving");
  const std::string lost = reading_error(testing::table_case("bad/unix-lost-digits.csv"));
  expect_part(lost, "unix-lost-digits.csv:3: found 1.780301E+09 twice");
  expect_part(lost, "a spreadsheet may have shortened them");
  const std::string commas = reading_error(testing::table_case("bad/comma-and-comma.csv"));
  expect_part(commas, "comma-and-comma.csv:2: found 6 cells, expected 3");
  expect_part(commas, "decimal commas need semicolons or tabs");
}

TEST(motion_record_cases, unevenly_rounded_times_are_rejected) {
  const testing::WrittenFile file("motion.csv", "time,heave_m\n1.78030080E+09,0\n1.78030081E+09,1\n1.78030083E+09,0\n");
  expect_part(reading_error(file.path()), "motion.csv:4: found times rounded to 10 s, in steps of 10 s to 20 s");
}

TEST(motion_record_cases, keys_must_name_columns_of_the_file) {
  const std::string text = "t_s,wind,heave_m\n0,5,0.1\n1,6,0.2\n";
  const testing::WrittenFile file("motion.csv", text);
  expect_part(reading_error(file.path(), {{"gust", "unused"}, {"wind", "unused"}}), "no column 'gust'");
  Diagnostics diagnostics;
  EXPECT_TRUE(read_motion_history(file.path(), 0.0, diagnostics, {{"wind", "unused"}}));
  expect_part(testing::all_messages(diagnostics), "columns that are not used: wind");
}

TEST(motion_record_cases, a_record_that_starts_before_zero_keeps_its_times) {
  const testing::WrittenFile file("motion.csv", "time_s,heave_m\n-1,0.1\n0,0.2\n1,0.1\n");
  Diagnostics diagnostics;
  const auto history = read_motion_history(file.path(), 0.0, diagnostics);
  ASSERT_TRUE(history);
  EXPECT_EQ(history->time.front(), -1.0);
  EXPECT_EQ(testing::all_messages(diagnostics), "");
}

TEST(motion_record_cases, a_spreadsheet_is_rejected_with_the_remedy) {
  const testing::WrittenFile file("motion.xlsx", "PK\x03\x04...");
  expect_part(reading_error(file.path()), "save the sheet as CSV");
}

}  // namespace
}  // namespace overbend
