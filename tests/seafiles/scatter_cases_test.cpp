// Scatter diagrams as metocean reports print them.
#include <gtest/gtest.h>

#include <algorithm>

#include "model/waves/peak_period.h"
#include "seafiles/scatter_reader.h"
#include "support/table_cases.h"

namespace overbend {
namespace {

struct Reading {
  std::optional<ScatterDiagram> diagram;
  std::string messages;
};

Reading read_case(const std::string& name, const WavesDescription& waves,
                  std::optional<ScatterPeriod> period = std::nullopt) {
  Diagnostics diagnostics;
  Reading reading;
  reading.diagram = read_scatter(testing::table_case(name), diagnostics, {period, &waves});
  reading.messages = testing::all_messages(diagnostics);
  return reading;
}

WavesDescription jonswap(std::optional<double> gamma) {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.gamma = gamma;
  return waves;
}

struct Expected {
  std::size_t seas;
  double mean_hs, mean_period, below_two;
  double max_hs, max_period, max_share;  ///< The most frequent sea.
};

/// Compares with periods that are `ratio` times those of the file.
void expect_diagram(const ScatterDiagram& diagram, const Expected& expected, double ratio) {
  ASSERT_EQ(diagram.seas.size(), expected.seas);
  double hs = 0.0, period = 0.0, below = 0.0, total = 0.0;
  for (const ScatterDiagram::Sea& sea : diagram.seas) {
    hs += sea.fraction[0] * sea.hs;
    period += sea.fraction[0] * sea.tp;
    total += sea.fraction[0];
    if (sea.hs + 0.5 * sea.hs_width <= 2.0 + 1e-9) below += sea.fraction[0];
  }
  EXPECT_NEAR(total, 1.0, 1e-12);
  EXPECT_NEAR(hs, expected.mean_hs, 1e-9);
  EXPECT_NEAR(period / ratio, expected.mean_period, 1e-9);
  EXPECT_NEAR(below, expected.below_two, 1e-9);
  const auto frequent = std::max_element(diagram.seas.begin(), diagram.seas.end(),
                                         [](const auto& a, const auto& b) { return a.fraction[0] < b.fraction[0]; });
  EXPECT_DOUBLE_EQ(frequent->hs, expected.max_hs);
  EXPECT_NEAR(frequent->tp / ratio, expected.max_period, 1e-9);
  EXPECT_NEAR(frequent->fraction[0], expected.max_share, 1e-9);
}

TEST(scatter_cases, counts_by_mean_period_with_totals_and_uneven_heights) {
  const Reading reading = read_case("scatter/scatter-tz-counts.csv", jonswap(3.3));
  ASSERT_TRUE(reading.diagram) << reading.messages;
  expect_diagram(*reading.diagram,
                 {81, 1.6408609139086092, 6.5062493750624935, 0.7223277672232776, 0.75, 5.5, 1398.0 / 20002.0},
                 tp_over_tz(3.3));
  EXPECT_EQ(reading.diagram->seas.back().hs_width, 1.0);
  EXPECT_NE(reading.messages.find("values that add up to 20002; Tp = 1.2863 Tz of JONSWAP spectra with gamma 3.3"),
            std::string::npos)
      << reading.messages;
}

TEST(scatter_cases, per_cent_by_peak_period_with_decimal_commas) {
  const Reading reading = read_case("scatter/scatter-tp-percent.csv", {});
  ASSERT_TRUE(reading.diagram) << reading.messages;
  expect_diagram(*reading.diagram,
                 {49, 1.6707579242075794, 8.328317168283172, 0.7278272172782722, 0.75, 7.0, 10.65 / 100.01}, 1.0);
  EXPECT_NE(reading.messages.find("per cent that add up to 100.01"), std::string::npos) << reading.messages;
}

TEST(scatter_cases, shares_by_mean_period_with_tabs) {
  WavesDescription waves;
  waves.type = WaveType::pierson_moskowitz;
  const Reading reading = read_case("scatter/scatter-tz-share.tsv", waves);
  ASSERT_TRUE(reading.diagram) << reading.messages;
  expect_diagram(*reading.diagram, {48, 1.59149, 6.393280000000001, 0.73647, 1.5, 6.0, 0.11084}, tp_over_tz(1.0));
  EXPECT_NE(reading.messages.find("Tp = 1.4077 Tz"), std::string::npos) << reading.messages;
}

TEST(scatter_cases, mean_periods_without_gamma_follow_the_rule_of_each_sea) {
  const Reading reading = read_case("scatter/scatter-tz-counts.csv", jonswap({}));
  ASSERT_TRUE(reading.diagram) << reading.messages;
  EXPECT_DOUBLE_EQ(reading.diagram->seas.front().tp, peak_period(0.25, 3.5, {}));
  EXPECT_NE(reading.messages.find("DNV-RP-C205"), std::string::npos) << reading.messages;
}

TEST(scatter_cases, mean_periods_need_a_spectrum) {
  const Reading reading = read_case("scatter/scatter-tz-counts.csv", {});
  EXPECT_FALSE(reading.diagram);
  EXPECT_NE(reading.messages.find("jonswap or pierson_moskowitz"), std::string::npos) << reading.messages;
}

TEST(scatter_cases, a_key_must_agree_with_the_header) {
  const Reading reading = read_case("scatter/scatter-tp-percent.csv", jonswap(3.3), ScatterPeriod::tz);
  EXPECT_FALSE(reading.diagram);
  EXPECT_NE(reading.messages.find("operability.scatter_period: tz"), std::string::npos) << reading.messages;
}

TEST(scatter_cases, a_negative_count_is_rejected_with_its_place) {
  const Reading reading = read_case("bad/scatter-negative.csv", jonswap(3.3));
  EXPECT_FALSE(reading.diagram);
  EXPECT_NE(reading.messages.find("scatter-negative.csv:5: column 4: found '-742' under 5-6"), std::string::npos)
      << reading.messages;
}

}  // namespace
}  // namespace overbend
