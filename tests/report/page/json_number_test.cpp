#include "report/page/json_number.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace overbend {
namespace {

TEST(json_number, has_seven_significant_digits_at_any_magnitude) {
  EXPECT_EQ(json_number(3.14159265).dump(), "3.141593");
  EXPECT_EQ(json_number(-330165904.2).dump(), "-330165900.0");
  EXPECT_EQ(json_number(123456789.0).dump(), "123456800.0");
  for (int exponent = 7; exponent <= 20; ++exponent) {
    for (const int digits : {1000001, 1234567, 2300009, 5150003, 9999999}) {
      const double value = digits * std::pow(10.0, exponent - 6);
      std::string text = json_number(value * (1.0 + 1e-9)).dump();
      text = text.substr(0, text.find_first_of("e"));
      std::erase(text, '.');
      text.erase(text.find_last_not_of('0') + 1);
      EXPECT_LE(text.size(), 7U) << text << " e" << exponent;
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
