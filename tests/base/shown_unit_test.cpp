#include "base/shown_unit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/units.h"
#include "support/us_units.h"

namespace overbend {
namespace {

TEST(shown_unit, is_the_engineers_for_si_and_the_same_where_the_table_has_none) {
  EXPECT_EQ(shown_unit("top_tension", "N").name, "kN");
  EXPECT_DOUBLE_EQ(shown_unit("overbend_von_mises", "Pa").factor * 250e6, 250.0);
  EXPECT_EQ(shown_unit("curvature", "1/m").name, "1/m");
  EXPECT_EQ(shown_unit("curvature", "1/m").factor, 1.0);
}

TEST(shown_unit, goes_by_the_name_for_strains_dents_and_fractions_of_time) {
  EXPECT_EQ(shown_unit("sagbend_max_strain", "1").name, "%");
  EXPECT_EQ(shown_unit("design strain", "1").factor, 100.0);
  EXPECT_EQ(shown_unit("strain", "J").name, "kJ");  // an energy
  EXPECT_EQ(shown_unit("dent_depth", "m").name, "mm");
  EXPECT_EQ(unit_label(shown_unit("energy_drift", "1")), "-");
}

TEST(shown_unit, is_customary_in_the_united_states_where_that_is_asked_for) {
  const UsUnits units;
  EXPECT_EQ(shown(1e6 * 0.45359237 * 9.80665, "N", 1), "1000.00 kip");
  EXPECT_EQ(shown(100.0 * 0.3048, "m", 2), "100.00 ft");
  EXPECT_EQ(shown(6.894757293168361e6, "Pa", 1), "1.00 ksi");
  EXPECT_EQ(shown(0.4064, section_length(), 1), "16.000 in");
  EXPECT_EQ(shown(1355.8179483314004, "N m", 0), "1.0 kip ft");
  EXPECT_EQ(shown_digits(100.0 * 0.3048, "m", 4), "100 ft");
}

TEST(shown_unit, us_numbers_keep_the_precision_of_the_metric_ones) {
  const std::span<const ShownUnit> metric = shown_units(UnitSystem::metric), us = shown_units(UnitSystem::us);
  ASSERT_EQ(metric.size(), us.size());
  for (std::size_t i = 0; i < us.size(); ++i) {
    EXPECT_EQ(us[i].si, metric[i].si);
    const double last_metric = std::pow(10.0, -metric[i].digits) / metric[i].factor;  // in SI
    EXPECT_LE(std::pow(10.0, -(metric[i].digits + us[i].more)) / us[i].factor, 2.3 * last_metric) << us[i].name;
  }
}

TEST(shown_unit, a_number_is_never_minus_zero_nor_not_a_number) {
  EXPECT_EQ(shown(-0.04, "m", 1), "0.0 m");
  EXPECT_EQ(shown_number(std::nan(""), "N", 1), "-");
}

TEST(shown_unit, of_stiffness_weight_and_moduli_are_those_that_engineers_read) {
  EXPECT_EQ(shown_digits(39.6e6, contact_stiffness_unit(), 3), "39.6 MN/m");
  EXPECT_EQ(shown(165.5e6, axial_stiffness_unit(), 1), "165.5 MN");
  EXPECT_EQ(shown_digits(207e9, modulus_unit(), 4), "207 GPa");
  EXPECT_EQ(shown_digits(812.5, line_weight_unit(), 4), "812.5 N/m");
  EXPECT_EQ(shown_digits(100e3, bed_stiffness_unit(), 4), "100 kN/m");
  EXPECT_EQ(shown_digits_number(245.5e3, shown_unit("N"), 4), "245.5");
  const UsUnits us;
  EXPECT_EQ(shown_digits(1e6, contact_stiffness_unit(), 4), "5.71 kip/in");  // 224.81 kip over 39.370 in
  EXPECT_EQ(shown(1e6, axial_stiffness_unit(), 1), "225 kip");
  EXPECT_EQ(shown_digits(207e9, modulus_unit(), 4), "30023 ksi");
  EXPECT_EQ(shown_digits(1000.0, line_weight_unit(), 4), "68.52 lbf/ft");
  EXPECT_EQ(shown_digits(100e3, bed_stiffness_unit(), 4), "2089 lbf/ft");  // per foot of penetration
  EXPECT_EQ(shown_digits(400.0, "m", 3), "1312 ft");
}

/// A value that is printed with its unit, as it is pasted into a model file.
void expect_reads_back(const ShownUnit& unit) {
  const std::string text = unit.name.empty() ? "2 %" : "2 " + std::string(unit.name);
  const double si = unit.name.empty() ? 0.02 : 2.0 / unit.factor;
  const QuantityReading got = parse_quantity(text, unit.si == "-" ? "1" : std::string(unit.si));
  ASSERT_TRUE(got.value.has_value()) << text << ": " << got.found;
  EXPECT_NEAR(*got.value, si, 1e-14 * si) << text;  // a few roundings
}

TEST(shown_unit, every_unit_that_is_printed_is_read_back_as_the_same_value) {
  for (const UnitSystem system : {UnitSystem::metric, UnitSystem::us}) {
    for (const ShownUnit& unit : shown_units(system)) expect_reads_back(unit);
    for (const SpecialUnit& own_unit : special_units(system)) expect_reads_back(own_unit.unit);
  }
  for (const char* si : {"1/m", "1/s", "Hz", "N m/rad", "N m2", "kg/m", "m/s", "m2", "m4", "m^2", "N", "N m", "J"}) {
    expect_reads_back({si, si, 1.0, 3});
  }
}

}  // namespace
}  // namespace overbend
