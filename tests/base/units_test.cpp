#include "base/units.h"

#include <gtest/gtest.h>

#include <numbers>
#include <stdexcept>
#include <thread>
#include <vector>

namespace overbend {
namespace {

struct Reading {
  const char* text;
  const char* unit;
  double si;
};

// Factors from the definitions of the units (in = 25.4 mm, lb = 0.45359237 kg, g = 9.80665 m/s2).
const Reading kReadings[] = {
    {"406.4 mm", "m", 0.4064},
    {"16 in", "m", 0.4064},
    {"1 ft", "m", 0.3048},
    {"250 kN", "N", 250e3},
    {"55 kip", "N", 55e3 * 0.45359237 * 9.80665},
    {"1 tf", "N", 9806.65},
    {"12 ksi", "N/m^2", 12e3 * 0.45359237 * 9.80665 / (0.0254 * 0.0254)},
    {"207000 MPa", "N/m^2", 207e9},
    {"207 GPa", "N/m^2", 207e9},
    {"100 kN/m^2", "N/m^2", 1e5},
    {"100 kN/m2", "N/m^2", 1e5},
    {"414 N/mm^2", "N/m^2", 414e6},
    {"10.05 kN/m^3", "N/m^3", 10050.0},
    {"64 pcf", "N/m^3", 64.0 * 0.45359237 * 9.80665 / (0.3048 * 0.3048 * 0.3048)},
    {"1e6 kN/m", "N/m", 1e9},
    {"1 lbf/ft", "N/m", 0.45359237 * 9.80665 / 0.3048},
    {"2 s", "s", 2.0},
    {"3 h", "s", 10800.0},
    {"10 min", "s", 600.0},
    {"1 knot", "m/s", 1852.0 / 3600.0},
    {"180 deg", "rad", std::numbers::pi},
    {"-0 deg", "rad", 0.0},
    {"1.5 rad", "rad", 1.5},
    {"90°", "rad", std::numbers::pi / 2.0},
    {"-48.900 m", "m", -48.9},
    {"+.5 m", "m", 0.5},
    {"5. m", "m", 5.0},
    {"2.5mm", "m", 0.0025},
    {"1 te", "kg", 1000.0},
    {"3 kN.s/m^2", "N*s/m^2", 3000.0},
};

TEST(units, quantities_read_to_si) {
  for (const Reading& r : kReadings) {
    const QuantityReading got = parse_quantity(r.text, r.unit);
    ASSERT_TRUE(got.value.has_value()) << r.text << ": " << got.found;
    // A conversion is at most a few roundings away from the definition.
    EXPECT_NEAR(*got.value, r.si, 4e-16 * 4.0 * std::abs(r.si)) << r.text;
  }
}

struct BadUnit {
  const char* text;
  const char* unit;
  const char* expected_text;  ///< Must be in the message.
};

const BadUnit kRefusals[] = {
    {"89", "m", "without a unit"},
    {"89 kN", "m", "a force"},
    {"30 deg", "m", "an angle"},
    {"3 m", "rad", "a length"},
    {"3", "rad", "without a unit"},
    {"50 %", "rad", "a plain number"},
    {"3 rad", "1", "an angle"},
    {"3 s^2/m", "1", "another dimension"},
    {"1025 kg/m^3", "N/m^3", "a mass density"},
    {"25 te", "N", "a mass"},
    {"5 furlongz", "m", "unknown unit"},
    {"1,5 m", "m", "decimal sign"},
    {"m", "m", "'m'"},
    {"", "m", "''"},
    {"012 m", "m", "decimal number"},
    {"0x10 m", "m", "unknown unit"},
    {"1e400 m", "m", "decimal number"},
    {".nan m", "m", "'.nan m'"},
    {"nan m", "m", "'nan m'"},
    {"inf m", "m", "'inf m'"},
    {"3 2 m", "m", "unknown unit"},
    {"3 -m", "m", "unknown unit"},
    {"3 m @ 5", "m", "unknown unit"},
    {"3 m from 5", "m", "unknown unit"},
    {"3 lg(re 1 m)", "m", "unknown unit"},
    {"3 degC", "m", "unknown unit"},
    {"20 m/s", "m", "a speed"},
    {"3 rad/m", "1/s", "another dimension"},
};

TEST(units, anything_else_is_rejected_with_its_reason) {
  for (const BadUnit& r : kRefusals) {
    const QuantityReading got = parse_quantity(r.text, r.unit);
    EXPECT_FALSE(got.value.has_value()) << r.text;
    EXPECT_NE((got.found + got.hint).find(r.expected_text), std::string::npos)
        << r.text << ": " << got.found << " " << got.hint;
  }
}

TEST(units, a_mass_where_a_weight_belongs_is_answered_with_the_weight) {
  const QuantityReading got = parse_quantity("7850 kg/m^3", "N/m^3");
  EXPECT_NE(got.hint.find("76.982 kN/m^3"), std::string::npos) << got.hint;
}

TEST(units, a_unit_in_wrong_case_is_answered_with_the_right_one) {
  EXPECT_NE(parse_quantity("3 mpa", "N/m^2").hint.find("'MPa'"), std::string::npos);
}

TEST(units, usual_units_of_every_dimension_measure_it) {
  for (const char* si : {"m", "rad", "s", "m/s", "m/s^2", "N", "N/m", "N/m^2", "N/m^3", "N*s/m^2", "N*m", "kg"}) {
    ASSERT_FALSE(usual_units(si).empty()) << si;
    for (const std::string& unit : usual_units(si)) EXPECT_TRUE(unit_factor(unit, si).has_value()) << unit;
  }
}

TEST(units, formatting_and_reading_return_the_value) {
  EXPECT_EQ(format_quantity(0.4064, "m", "mm"), "406.4 mm");
  EXPECT_EQ(format_quantity(0.0, "rad", "deg"), "0 deg");
  EXPECT_THROW(format_quantity(1.0, "m", "kN"), std::logic_error);
  const std::string text = format_quantity(1234.5678, "N", "kN", 15);
  EXPECT_NEAR(parse_quantity(text, "N").value.value_or(0.0), 1234.5678, 1e-11);
}

TEST(units, only_plain_decimal_numbers_are_numbers) {
  for (const char* text : {"0", "1", "-1", "+1", "0.5", ".5", "5.", "1e-9", "1E+3", "-0", "0e0", "10"}) {
    EXPECT_TRUE(parse_number(text).has_value()) << text;
  }
  for (const char* text : {"",   "-",     ".",   "e5",   "012",  "-012", "00",  "0x1", "0o7",      "1_000", "1 2", " 1",
                           "1e", "1e400", "1,5", ".nan", ".inf", "inf",  "nan", "NaN", "infinity", "1f",    "--1"}) {
    EXPECT_FALSE(parse_number(text).has_value()) << text;
  }
}

TEST(units, threads_may_read_at_once) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(8, 0);
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([t, &wrong] {
      for (const Reading& r : kReadings) {
        const auto value = parse_quantity(r.text, r.unit).value;
        if (!value || std::abs(*value - r.si) > 1e-14 * std::abs(r.si)) ++wrong[t];
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(8, 0));
}

}  // namespace
}  // namespace overbend
