#include "report/page/json_number.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace overbend {
namespace {

TEST(json_number, has_seven_significant_digits_at_any_magnitude) {
  EXPECT_EQ(json_number(3.14159265).dump(), "3.141593");
  EXPECT_EQ(json_number(-330165904.2).dump(), "-330165900.0");
  EXPECT_EQ(json_number(123456789.0).dump(), "123456800.0");
  for (int exponent = -12; exponent <= 20; ++exponent) {
    for (const int digits : {1000001, 1234567, 2300009, 5150003, 9999999}) {
      const double value = digits * std::pow(10.0, exponent - 6) * (1.0 + 1e-9);
      EXPECT_EQ(seven_digits(value), std::stod(fmt::format("{:.6e}", value)));
    }
  }
}

TEST(json_number, is_null_for_a_missing_value) {
  EXPECT_EQ(json_number(std::nan("")).dump(), "null");
  EXPECT_EQ(json_number(-0.0).dump(), "0");
  EXPECT_EQ(seven_digits(std::numeric_limits<double>::infinity()), 0.0);
}

}  // namespace
}  // namespace overbend
