#include "model/waves/rao_table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "model/vessel/rao_limits.h"
#include "support/rao_files.h"

namespace overbend {
namespace {

using Complex = std::complex<double>;

/// Two headings, two frequencies; freedom k of heading i at frequency j has the value base + i + 10 j + 100 k.
RaoTable small_table(std::vector<double> headings) {
  RaoTable table;
  table.headings = std::move(headings);
  table.omegas = {0.5, 1.0};
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      for (std::size_t k = 0; k < 6; ++k) {
        table.values.emplace_back(1.0 + static_cast<double>(i) + 10.0 * static_cast<double>(j),
                                  100.0 * static_cast<double>(k));
      }
    }
  }
  return table;
}

TEST(rao_table, points_of_the_table_come_back) {
  const RaoTable& table = testing::bgl1_raos();
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    for (std::size_t j = 0; j < table.omegas.size(); ++j) {
      const RaoTable::Response r = table.at(table.headings[i], table.omegas[j]);
      for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(std::abs(r[k] - table.value(i, j, k)), 0.0, 1e-14);
    }
  }
}

TEST(rao_table, passes_through_zero_in_a_straight_line_where_amplitude_and_phase_would_jump) {
  RaoTable table = small_table({0.0, 180.0 * kDegree});
  for (std::size_t i = 0; i < 2; ++i) {
    table.values[(i * 2 + 0) * 6 + 4] = Complex(0.02, 0.0);
    table.values[(i * 2 + 1) * 6 + 4] = Complex(-0.02, 0.0);
  }
  EXPECT_NEAR(std::abs(table.at(0.0, 0.75)[4]), 0.0, 1e-16);
  EXPECT_NEAR(table.at(0.0, 0.7)[4].real(), 0.004, 1e-15);
  EXPECT_NEAR(table.at(0.0, 0.8)[4].real(), -0.004, 1e-15);
}

TEST(rao_table, headings_are_periodic) {
  const RaoTable table = small_table({10.0 * kDegree, 130.0 * kDegree, 250.0 * kDegree});
  ASSERT_FALSE(table.one_sided());
  EXPECT_NEAR(table.at(310.0 * kDegree, 0.5)[0].real(), 0.5 * (3.0 + 1.0), 1e-12) << "half way from 250 to 370 deg";
  EXPECT_NEAR(std::abs(table.at(-50.0 * kDegree, 0.5)[0] - table.at(310.0 * kDegree, 0.5)[0]), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(table.at(740.0 * kDegree, 0.5)[0] - table.at(20.0 * kDegree, 0.5)[0]), 0.0, 1e-12);
}

TEST(rao_table, one_side_serves_the_other_as_its_mirror_image) {
  const RaoTable& whole = testing::bgl1_raos();
  RaoTable half = whole;
  half.headings.clear();
  half.values.clear();
  for (std::size_t i = 0; i < whole.headings.size(); ++i) {
    if (whole.headings[i] > 170.0 * kDegree || whole.headings[i] < 10.0 * kDegree) continue;  // not even 0 and 180
    half.headings.push_back(whole.headings[i]);
    for (std::size_t n = 0; n < whole.omegas.size() * 6; ++n) {
      half.values.push_back(whole.values[i * whole.omegas.size() * 6 + n]);
    }
  }
  ASSERT_TRUE(half.one_sided());
  for (const double heading : {20.0, 90.0, 160.0, 200.0, 285.0, 333.0}) {
    const RaoTable::Response a = whole.at(heading * kDegree, 0.6), b = half.at(heading * kDegree, 0.6);
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(std::abs(a[k] - b[k]), 0.0, 1e-6) << heading << kFreedomNames[k];
  }
  EXPECT_NEAR(std::abs(half.at(0.0, 0.6)[1]), 0.0, 1e-12) << "sway astern is half way between opposite images";
  EXPECT_GT(std::abs(half.at(0.0, 0.6)[0]), 0.2);
}

TEST(rao_table, beyond_its_frequencies_it_holds_vanishes_and_fades) {
  const RaoTable table = small_table({0.0, 90.0 * kDegree});
  EXPECT_EQ(table.at(0.0, 0.1)[2], table.at(0.0, 0.5)[2]) << "translations go with long waves";
  EXPECT_NEAR(std::abs(table.at(0.0, 0.1)[4] - 0.2 * table.at(0.0, 0.5)[4]), 0.0, 1e-12) << "slopes vanish";
  EXPECT_NEAR(std::abs(table.at(0.0, 1.125)[2] - 0.5 * table.at(0.0, 1.0)[2]), 0.0, 1e-12);
  EXPECT_EQ(std::abs(table.at(0.0, 1.25)[2]), 0.0);
  EXPECT_EQ(std::abs(table.at(0.0, 3.0)[4]), 0.0);
}

TEST(rao_limits, the_barge_follows_very_long_waves_as_its_readme_says) {
  const RaoLimits limits = long_wave_limits(testing::bgl1_raos(), 120.0, 5.182, 89.0);
  EXPECT_TRUE(limits.long_enough);
  EXPECT_NEAR(limits.wave_length, 1828.0, 1.0);
  ASSERT_EQ(limits.rows.size(), 9U);
  for (const RaoLimitRow& row : limits.rows) {
    EXPECT_NEAR(row.ratio, 1.0, 0.01) << row.heading << " " << row.freedom;
    EXPECT_NEAR(std::remainder(row.lag - row.expected_lag, 2.0 * kPi), 0.0, 1.0 * kDegree);
  }
  // 3.357 is the sway of the file, 3.362 the mean orbit of its README.
  EXPECT_NEAR(limits.rows[3].ratio, 3.357 / 3.362, 5e-4);
  EXPECT_TRUE(limit_findings(limits).empty());
}

TEST(rao_limits, a_wrong_phase_sign_and_a_wrong_unit_show) {
  for (const auto& [key, word] : {std::pair{"phase", "lead"},
                                  {"rotation", "rad_per_m"},
                                  {"phase_zero", "trough"},
                                  {"positive.pitch", "bow_up"},
                                  {"heading_zero", "bow"}}) {
    RaoSettings given;
    given.values[key] = word;
    const RaoTable table = testing::good_raos(testing::bgl1_file("rao.csv"), given);
    EXPECT_FALSE(limit_findings(long_wave_limits(table, 120.0, 5.182, 89.0)).empty()) << key << " " << word;
  }
}

TEST(rao_limits, a_freedom_that_disagrees_is_warned_of_once_with_all_its_headings) {
  RaoSettings given;
  given.values["phase"] = "lead";
  const RaoTable table = testing::good_raos(testing::bgl1_file("rao.csv"), given);
  const std::vector<std::string> warnings = messages(limit_findings(long_wave_limits(table, 120.0, 5.182, 89.0)));
  ASSERT_EQ(warnings.size(), 4U);  // surge, pitch, sway, roll; heave has no sign to get wrong
  EXPECT_EQ(warnings.front().find("RAOs: in long waves travelling towards 0 and 180 deg surge is "), 0U)
      << warnings.front();
}

TEST(rao_limits, waves_that_are_not_long_judge_nothing) {
  RaoSettings given;
  given.values["phase"] = "lead";
  const RaoTable table = testing::good_raos(testing::bgl1_file("rao.csv"), given);
  EXPECT_TRUE(limit_findings(long_wave_limits(table, 500.0, 5.182, 89.0)).empty());
}

}  // namespace
}  // namespace overbend
