#include "base/unit_spelling.h"

#include <gtest/gtest.h>

#include "base/units.h"

namespace overbend {
namespace {

struct Reading {
  const char *text, *unit;
  double si;
};

// g = 9.80665 m/s2, in = 25.4 mm, lb = 0.45359237 kg; the nautical mile has 1852 m.
constexpr double kPoundForce = 0.45359237 * 9.80665, kFoot = 0.3048;

TEST(unit_spelling, units_are_read_as_this_trade_writes_them) {
  const Reading readings[] = {
      {"30.6 mt", "kg", 30600.0},
      {"30.6 MT", "kg", 30600.0},
      {"30.6 te", "kg", 30600.0},
      {"30.6 t", "kg", 30600.0},
      {"30.6 tf", "N", 30600.0 * 9.80665},
      {"30.6 tonf", "N", 30600.0 * 9.80665},
      {"30.6 mtf", "N", 30600.0 * 9.80665},
      {"2 tf/m", "N/m", 2000.0 * 9.80665},
      {"1.2 t/m3", "kg/m^3", 1200.0},
      {"400 kNm", "N*m", 4e5},
      {"400 kN·m", "N*m", 4e5},
      {"400 kN⋅m", "N*m", 4e5},
      {"400 kN-m", "N*m", 4e5},
      {"3 MNm2", "N*m^2", 3e6},
      {"3 kNm^2", "N*m^2", 3e3},
      {"3 kNs/m", "N*s/m", 3e3},
      {"300 kip-ft", "N*m", 3e5 * kPoundForce * kFoot},
      {"0.02 1/m", "m-1", 0.02},
      {"0.02 m-1", "m-1", 0.02},
      {"0.1 1/s", "1/s", 0.1},
      {"0.5 rad/s", "rad/s", 0.5},
      {"100 kPa", "N/m^2", 1e5},
      {"100 kN/m2", "N/m^2", 1e5},
      {"2 ksf", "N/m^2", 2e3 * kPoundForce / (kFoot * kFoot)},
      {"60 ksi", "N/m^2", 60e3 * kPoundForce / (0.0254 * 0.0254)},
      {"190 pcf", "N/m^3", 190.0 * kPoundForce / (kFoot * kFoot * kFoot)},
      {"5 m2", "m^2", 5.0},
      {"1025 kg/m3", "kg/m^3", 1025.0},
      {"250 lbs", "kg", 250.0 * 0.45359237},
      {"2 kn", "m/s", 2.0 * 1852.0 / 3600.0},
      {"2 kt", "m/s", 2.0 * 1852.0 / 3600.0},
      {"2 kts", "m/s", 2.0 * 1852.0 / 3600.0},
      {"3 NM", "m", 5556.0},
      {"3 nmi", "m", 5556.0},
      {"3 hrs", "s", 10800.0},
  };
  for (const Reading& r : readings) {
    const QuantityReading got = parse_quantity(r.text, r.unit);
    ASSERT_TRUE(got.value.has_value()) << r.text << ": " << got.found;
    EXPECT_NEAR(*got.value, r.si, 4e-15 * r.si) << r.text;  // a few roundings
  }
}

struct BadUnit {
  const char *text, *unit, *hint;
};

TEST(unit_spelling, the_hint_of_a_wrong_unit_has_the_value_that_was_meant) {
  const BadUnit rejections[] = {
      {"30.6 mt", "N", "its weight is 300.08 kN"},
      {"30.6 MT", "N", "its weight is 300.08 kN"},
      {"30 T", "N", "write t for tonnes"},
      {"300 kn", "N", "did you mean 'kN'"},
      {"12.75 \"", "m", "write in for inches"},
      {"5 '", "m", "write ft for feet"},
      {"5 nm", "m", "write nmile for nautical miles"},
      {"0.1 Hz", "rad/s", "the angular frequency is 0.62832 rad/s"},
      {"0.62832 rad/s", "1/s", "the frequency is 0.1"},
      {"1.2 t/m", "N/m", "its weight is 11.768 kN/m"},
  };
  for (const BadUnit& r : rejections) {
    const QuantityReading got = parse_quantity(r.text, r.unit);
    EXPECT_FALSE(got.value.has_value()) << r.text;
    EXPECT_NE(got.hint.find(r.hint), std::string::npos) << r.text << ": " << got.hint;
  }
}

TEST(unit_spelling, units_of_two_meanings_are_taken_with_a_remark) {
  EXPECT_NE(parse_quantity("20 ton", "kg").remark.find("short ton"), std::string::npos);
  EXPECT_NE(parse_quantity("20 tonf", "N").remark.find("9.80665 kN"), std::string::npos);
  for (const char* unit : {"tonne", "t", "tf", "kN", "kips"}) EXPECT_EQ(ambiguity_remark(unit), "") << unit;
}

}  // namespace
}  // namespace overbend
