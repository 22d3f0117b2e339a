#include "statics/moored/hull_statics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "support/hull_case.h"

namespace overbend {
namespace {

/// BGL-1 heading east on lines whose stiffness about its centre of gravity is that of eight wires at 300 kN, in waves
/// of 4 m that travel north: onto its starboard side.
std::optional<HullStatics> reported() {
  Description d = testing::bgl1_hull_description();
  d.environment.waves.front().type = WaveType::jonswap;
  d.environment.waves.front().hs = 4.0;
  d.environment.waves.front().tp = 12.9;
  d.environment.waves.front().from = std::numbers::pi;
  MooredState rest;
  rest.mooring_stiffness.assign(36, 0.0);
  rest.mooring_stiffness[0] = rest.mooring_stiffness[7] = 1.8479e5;
  rest.mooring_stiffness[35] = 5.1281e8;
  rest.mooring_force.assign(6, 0.0);
  return compute_hull_statics(build_model(d), &rest);
}

const ModeDampingResult& mode(const HullResults& hull, const std::string& name) {
  return *std::find_if(hull.damping.begin(), hull.damping.end(), [&](const auto& m) { return m.mode == name; });
}

// Periods and mean drift of an independent prototype.
TEST(compute_hull_statics, reports_periods_drift_and_fit_of_the_moored_barge) {
  const std::optional<HullStatics> account = reported();
  ASSERT_TRUE(account);
  const HullResults& hull = account->results;
  ASSERT_EQ(hull.damping.size(), 3U);
  EXPECT_NEAR(mode(hull, "surge").period, 66.9, 0.4);
  EXPECT_NEAR(mode(hull, "sway").period, 77.1, 0.4);
  EXPECT_NEAR(mode(hull, "yaw").period, 44.6, 0.4);
  EXPECT_NEAR(hull.drift.sway / 1e3, 217.8, 2.2);
  EXPECT_NEAR(hull.drift.surge / 1e3, 0.0, 1.0);
  EXPECT_GT(hull.states, 60);
  EXPECT_FALSE(hull.groups.empty());
  for (const RadiationEntryResult& entry : hull.entries) EXPECT_LT(entry.damping_error, 0.011) << entry.first;
  for (const ModeDampingResult& mode_damping_result : hull.damping)
    EXPECT_GE(mode_damping_result.total, 0.0) << mode_damping_result.mode;
  EXPECT_FALSE(account->assumptions.empty());  // Newman
}

/// Munk's moment of a flow of 1 m/s at 45 deg: half the difference of both added masses, (8.509 - 1.813) 1,025 t at the
/// lowest frequency of the file. Strips about midship give none.
TEST(compute_hull_statics, reports_the_moment_by_which_a_current_turns_the_hull_across_itself) {
  Description d = testing::bgl1_hull_description();
  const double towards = 0.25 * std::numbers::pi;  // north-east; the bow points east
  d.environment.current = {{0.0, 1.0, towards}, {89.0, 1.0, towards}};
  d.vessel.coupled->current = {};
  const std::optional<HullStatics> account = compute_hull_statics(build_model(d), nullptr);
  ASSERT_TRUE(account);
  const double munk = 0.5 * (8.509056e6 - 1.813214e6) * 1.025;
  EXPECT_NEAR(std::abs(account->results.current.yaw), munk, 0.01 * munk);
}

TEST(compute_hull_statics, is_of_hulls_with_coefficients_alone) {
  Description d = testing::bgl1_hull_description();
  d.vessel.motion = VesselMotion::fixed;
  EXPECT_FALSE(compute_hull_statics(build_model(d), nullptr));
}

}  // namespace
}  // namespace overbend
