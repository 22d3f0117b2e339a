#include "seafiles/coefficient_table.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numbers>

namespace overbend {
namespace {

struct Reading {
  std::vector<CoefficientRow> rows;
  std::vector<std::string> errors;
};

Reading read(const std::string& text) {
  const auto path = std::filesystem::temp_directory_path() / ("overbend_cx_" + std::to_string(getpid()) + ".csv");
  std::ofstream(path) << text;
  Diagnostics diagnostics;
  Reading reading{read_coefficient_table(path.string(), diagnostics), {}};
  reading.errors = diagnostics.lines(Severity::error);
  std::filesystem::remove(path);
  return reading;
}

TEST(coefficient_table, half_a_table_is_mirrored_to_the_other_side) {
  const Reading r = read("# a barge\nangle_deg,cx,cy,cz\n0,1,0,0\n60,0.5,0.8,0.1\n120,-0.5,0.8,-0.1\n180,-1,0,0\n");
  ASSERT_TRUE(r.errors.empty()) << r.errors.front();
  ASSERT_EQ(r.rows.size(), 6U);
  EXPECT_NEAR(r.rows[4].angle, 240.0 * std::numbers::pi / 180.0, 1e-12);
  EXPECT_EQ(r.rows[4].cx, -0.5);
  EXPECT_EQ(r.rows[4].cy, -0.8);
  EXPECT_EQ(r.rows[4].cz, 0.1);
}

TEST(coefficient_table, a_whole_circle_stays_as_it_is) {
  const Reading r = read("angle_deg,cx,cy,cz\n0,1,0,0\n60,1,0,0\n120,1,0,0\n180,1,0,0\n240,1,0,0\n300,1,0,0\n");
  EXPECT_TRUE(r.errors.empty());
  EXPECT_EQ(r.rows.size(), 6U);
}

TEST(coefficient_table, every_slip_is_reported_with_its_line) {
  const auto expect = [](const std::string& text, const std::string& message) {
    const Reading r = read(text);
    ASSERT_EQ(r.errors.size(), 1U) << message;
    EXPECT_NE(r.errors[0].find(message), std::string::npos) << r.errors[0];
    EXPECT_TRUE(r.rows.empty());
  };
  const std::string head = "angle_deg,cx,cy,cz\n";
  expect("", "empty");
  expect("angle,cx,cy\n", "the header 'angle_deg,cx,cy,cz'");
  expect(head + "0,1,0\n45,1,0,0\n90,1,0,0\n", "3 columns");
  expect(head + "0,1,zero,0\n", ":2: cy: found 'zero'");
  expect(head + "0,1,0,0\n50,1,0,0\n40,1,0,0\n", "more than the angle before it");
  expect(head + "0,1,0,0\n90,1,0,0\n180,1,0,0\n270,1,0,0\n", "a gap of 90 deg");
}

}  // namespace
}  // namespace overbend
