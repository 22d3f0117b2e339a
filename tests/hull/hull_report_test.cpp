#include "hull/hull_report.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/hull_case.h"

namespace overbend {
namespace {

Mat6 moored() {
  Mat6 K = Mat6::Zero();
  K.diagonal() << 1.8479e5, 1.8479e5, 0.0, 0.0, 0.0, 5.1281e8;
  return K;
}

TEST(hull_report, gives_the_range_of_the_current_force) {
  Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  HullCurrent& c = made.hull.current;
  c.form = HullCurrentModel::strips;
  c.velocity = {0.0, 1.02};
  c.length = 120.0;
  c.draught = 5.182;
  c.transverse = 0.8;
  const HullReport report = hull_report(made, model, Sea{}, moored());
  EXPECT_NEAR(report.model_current_force / 1e3, 265.3, 0.2);
  EXPECT_NEAR(report.min_current_force / 1e3, 149.0, 0.2);  // C_yc 0.449 in 89 m; 146 kN by the 0.44 of deep water
  EXPECT_NEAR(report.max_current_force / 1e3, 397.9, 0.3);
  EXPECT_FALSE(report.radiation.entries.empty());
}

TEST(hull_report, warns_of_a_table_by_which_wind_from_ahead_pulls_the_hull_ahead) {
  const Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  const auto warnings_with = [&](double sign) {  // angles where it comes from, clockwise from the bow
    std::vector<CoefficientRow> rows;
    for (int i = 0; i < 12; ++i) {
      const double angle = i * std::numbers::pi / 6.0;
      rows.push_back({angle, -sign * 0.9 * std::cos(angle), 1.1 * std::sin(angle), 0.0});
    }
    made.hull.wind.table = {200.0, 900.0, 120.0, coefficients_from_bow(rows, CoefficientAxes::from_bow)};
    return hull_report(made, model, Sea{}, moored()).findings.size();
  };
  EXPECT_EQ(warnings_with(-1.0), warnings_with(1.0) + 1);
}

TEST(hull_report, reports_what_acts_steadily) {
  Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  const Sea sea = testing::long_crested(4.0, 12.9, 0.5 * std::numbers::pi, 1);
  made.hull.waves = make_hull_waves(testing::bgl1_hydrodynamics(), sea, WaveDrift::newman, 5.182, 0.0);
  const HullReport report = hull_report(made, model, sea, moored());
  EXPECT_NEAR(report.steady.drift(1), 217.8e3, 0.01 * 217.8e3);
  EXPECT_EQ(report.steady.current.norm(), 0.0);
}

TEST(hull_report, warns_of_positioning_whose_filter_takes_all_its_damping) {
  Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  made.hull.station_keeping = StationKeeping{made.hull.drawn.head<3>(), {Vec3(1e5, 1e5, 3e8), Vec3(1e5, 1e5, 1e8)}};
  const HullReport weak = hull_report(made, model, Sea{}, Mat6::Zero());
  EXPECT_LT(weak.damping[1].station_keeping, 0.0);
  EXPECT_GT(weak.findings.size(), made.findings.size());
  made.hull.station_keeping->law.damping = Vec3(4e6, 5e6, 1.5e10);
  EXPECT_GT(hull_report(made, model, Sea{}, Mat6::Zero()).damping[1].station_keeping, 0.1);
}

/// At the natural period of 71 s the damper seems to leave 37 % of critical damping, but the loop swings at 41 s.
TEST(hull_report, warns_of_positioning_that_lags_too_far_to_be_stable) {
  const double w = 2.0 * std::numbers::pi / 71.4;
  SlowLoop loop;
  loop.slow_stiffness = 2e8;
  loop.mass = loop.slow_stiffness / (w * w);
  loop.slow_damping = 8e9;
  loop.low_frequency_period = 40.0;
  const DampedOscillation found = find_least_damped(loop);
  EXPECT_NEAR(found.damping, -0.067, 0.001);
  EXPECT_NEAR(found.period, 41.2, 0.1);
  loop.low_frequency_period = 15.0;
  loop.slow_damping = 4e9;
  EXPECT_NEAR(find_least_damped(loop).damping, 0.419, 0.001);
  loop.slow_damping = loop.slow_stiffness = 0.0;  // nothing lags: the oscillator itself
  loop.stiffness = 2e8;
  loop.damping = 0.1 * 2.0 * loop.stiffness / w;
  EXPECT_NEAR(find_least_damped(loop).damping, 0.1, 1e-9);
  const Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  made.hull.station_keeping = StationKeeping{made.hull.drawn.head<3>(), {Vec3(1e5, 1e5, 2e8), Vec3(4e6, 4e6, 8e9)}};
  const HullReport report = hull_report(made, model, Sea{}, Mat6::Zero());
  EXPECT_GT(report.damping[2].total(), 0.0);
  EXPECT_TRUE(std::ranges::any_of(messages(report.findings), [](const std::string& warning) {
    return warning.find("is unstable in slow yaw") != std::string::npos;
  }));
}

TEST(hull_report, warns_of_a_sea_beyond_the_table_and_of_shallow_water) {
  Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  Sea sea = testing::long_crested(2.0, 12.0, 1.0, 1);
  made.hull.waves = make_hull_waves(testing::bgl1_hydrodynamics(), sea, WaveDrift::newman, 5.182, 0.0);
  const std::size_t others = made.findings.size();  // of the radiation
  const HullReport fine = hull_report(made, model, sea, moored());
  EXPECT_EQ(fine.findings.size(), others) << messages(fine.findings).back();
  made.hull.waves.above_table = 0.03;
  sea.depth = 8.0;
  const HullReport shallow = hull_report(made, model, sea, moored());
  ASSERT_EQ(shallow.findings.size(), others + 2);
  EXPECT_NE(messages(shallow.findings).back().find("k_p d of 0."), std::string::npos)
      << messages(shallow.findings).back();
}

TEST(hull_report, warns_of_drift_that_ends_below_the_waves) {
  const Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  const Sea sea = testing::long_crested(2.0, 8.0, 1.0, 1);  // peak at 0.785 rad/s
  const auto report_with = [&](double highest) {
    HydrodynamicData data = testing::bgl1_hydrodynamics();
    while (data.drift.omega.back() > highest) data.drift.omega.pop_back();
    data.mean_drift.resize(data.drift.omega.size() * data.drift.heading.size());
    made.hull.waves = make_hull_waves(data, sea, WaveDrift::newman, 5.182, 0.0);
    return hull_report(made, model, sea, moored());
  };
  const HullReport whole = report_with(10.0), cut = report_with(0.8);
  ASSERT_EQ(cut.findings.size(), whole.findings.size() + 1);
  const auto prescribed = [](const std::string& message) {
    return message.find("of the mean drift, which end") != std::string::npos;
  };
  EXPECT_TRUE(std::ranges::any_of(messages(cut.findings), prescribed));
  EXPECT_FALSE(std::ranges::any_of(messages(whole.findings), prescribed));
}

TEST(hull_report, warns_of_files_without_drift_in_a_sea_that_would_make_the_hull_drift) {
  const Model model = build_model(testing::bgl1_hull_description());
  MadeHull made = testing::made_bgl1_hull();
  const Sea sea = testing::long_crested(2.0, 12.0, 1.0, 1);
  HydrodynamicData without = testing::bgl1_hydrodynamics();
  without.mean_drift.clear();
  made.hull.waves = make_hull_waves(without, sea, WaveDrift::newman, 5.182, 0.0);
  const HullReport report = hull_report(made, model, sea, moored());
  ASSERT_FALSE(report.findings.empty());
  EXPECT_NE(messages(report.findings).back().find("no drift coefficients"), std::string::npos)
      << messages(report.findings).back();
}

}  // namespace
}  // namespace overbend
