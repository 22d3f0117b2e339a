#include "seafiles/file_time.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

constexpr FileTime kMorning = {2026, 6, 1, 9, 40, 0};

TEST(file_time, is_read_in_the_spellings_of_buoys_models_and_people) {
  for (const char* text : {"2026-06-01 09:40", "2026 06 01 09 40", "2026-06-01T09:40Z", "20260601.094000",
                           "26 06 01 09 40", "2026/6/1 9:40:00"}) {
    EXPECT_EQ(parse_file_time(text), kMorning) << text;
  }
  EXPECT_EQ(parse_file_time("2026-06-01"), (FileTime{2026, 6, 1, 0, 0, 0}));
  EXPECT_EQ(parse_file_time("99 12 31 23")->front(), 1999);
}

TEST(file_time, that_is_no_date_is_none) {
  for (const char* text : {"", "noon", "2026", "2026-06", "2026-13-01", "2026-06-32", "2026-06-01 25:00",
                           "2026060109400000", "1 2 3 4 5 6 7", "0-0-0"}) {
    EXPECT_FALSE(parse_file_time(text)) << text;
  }
}

TEST(file_time, label_has_seconds_only_where_there_are_some) {
  EXPECT_EQ(file_time_label(kMorning), "2026-06-01 09:40");
  EXPECT_EQ(file_time_label({2026, 6, 1, 9, 40, 5}), "2026-06-01 09:40:05");
}

std::string message(const std::vector<FileTime>& times, const std::string& wanted) {
  Diagnostics diagnostics;
  EXPECT_FALSE(choose_time(times, {"buoy.txt", "environment.waves.time", wanted}, diagnostics));
  return diagnostics.lines(Severity::error).front();
}

TEST(choose_time, takes_the_only_time_and_asks_for_one_of_several) {
  Diagnostics diagnostics;
  EXPECT_EQ(choose_time({kMorning}, {"buoy.txt", "key", ""}, diagnostics), 0U);
  const FileTime later = {2026, 6, 1, 11, 40, 0};
  EXPECT_EQ(choose_time({later, kMorning}, {"buoy.txt", "key", "2026-06-01 09:40"}, diagnostics), 1U);
  EXPECT_EQ(message({later, kMorning}, ""),
            "buoy.txt: environment.waves.time: found 2 times, 2026-06-01 09:40 to 2026-06-01 11:40, and no choice, "
            "expected one of them; for example time: 2026-06-01 09:40");
  EXPECT_NE(message({later, kMorning}, "2026-06-01 10:40").find("no row of 2026-06-01 10:40"), std::string::npos);
  EXPECT_NE(message({later, kMorning}, "noon").find("found 'noon'"), std::string::npos);
  EXPECT_NE(message({}, "").find("no row with a time"), std::string::npos);
}

}  // namespace
}  // namespace overbend
