#include "seafiles/clock_text.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(clock_text, is_hours_minutes_and_seconds_with_a_fraction) {
  EXPECT_EQ(parse_clock("23:59:40.500"), 86380.5);
  EXPECT_EQ(parse_clock("0:00:01,25"), 1.25);
  EXPECT_EQ(parse_clock("09:00:00"), 32400.0);
  for (const char* text : {"9:00", "9:60:00", "9:00:61", "9:00:00 x", "", "a:b:c", "-1:00:00", "123456:00:00"}) {
    EXPECT_FALSE(parse_clock(text)) << text;
  }
}

TEST(clock_text, dates_have_the_year_first_or_points) {
  const double day = 20605.0;  // 2026-06-01
  for (const char* text : {"2026-06-01T09:00:00.5Z", "2026-06-01 09:00:00.5", "2026/06/01 09:00:00,5",
                           "01.06.2026 09:00:00.5", "2026-06-01T11:00:00.5+02:00", "2026-06-01T09:00:00.5 UTC"}) {
    const auto time = parse_date_time(text);
    ASSERT_TRUE(time) << text;
    EXPECT_EQ(time->day, day) << text;
    EXPECT_EQ(time->seconds, 32400.5) << text;
  }
  for (const char* text : {"06/01/2026 09:00:00", "2026-13-01T09:00:00", "2026-06-01", "2026-06-01T09:00", "99999",
                           "2026-06-01T09:00:00+99:00", "2026-06-01T25:00:00"}) {
    EXPECT_FALSE(parse_date_time(text)) << text;
  }
}

TEST(clock_text, names_unix_times_in_utc) {
  EXPECT_EQ(unix_time_label(1780300800.0), "2026-06-01 08:00:00 UTC");
  EXPECT_EQ(unix_time_label(951782399.0), "2000-02-28 23:59:59 UTC");
  EXPECT_EQ(unix_time_label(951782400.0), "2000-02-29 00:00:00 UTC");
  EXPECT_EQ(unix_time_label(0.0), "1970-01-01 00:00:00 UTC");
}

}  // namespace
}  // namespace overbend
