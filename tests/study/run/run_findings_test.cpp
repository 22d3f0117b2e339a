#include "study/run/run_findings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.h"

namespace overbend {
namespace {

/// Three hours in which everything moves and the tension stays where it is wanted.
DynamicResults sound() {
  DynamicResults r;
  r.duration = 10800.0;
  r.output_step = 0.5;
  r.station_s = {0.0};
  r.extremes.resize(1);
  r.extremes[0].estimate = r.extremes[0].low = r.extremes[0].high = 300e3;
  r.histories = {{"elevation", "m", "", {-1.0, 1.0, 0.0, 0.5}, {}, {}},
                 {"heave", "m", "", {-0.1, 0.1, 0.0, 0.1}, {}, {}}};
  r.tensioner.wanted = 250e3;
  r.tensioner.tension = {200e3, 300e3, 251e3, 15e3};
  return r;
}

std::vector<double> swinging(std::size_t count, double rise) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(count);
    values.push_back(250e3 + 15e3 * std::sin(0.37 * static_cast<double>(i)) + rise * t);
  }
  return values;
}

std::vector<std::string> find_warnings(DynamicResults r, double rise = 0.0, WaveType type = WaveType::jonswap) {
  Description d;
  d.environment.waves.front().type = type;
  warn_of_run(d, r, swinging(4000, rise));
  return messages(r.findings);
}

bool only(const std::vector<std::string>& list, const std::string& message) {
  return list.size() == 1 && list[0].find(message) != std::string::npos;
}

TEST(run_findings, a_sound_run_has_none) {
  EXPECT_TRUE(find_warnings(sound()).empty());
}

TEST(run_findings, three_hours_from_minutes_say_how_many) {
  DynamicResults r = sound();
  r.duration = 300.0;
  EXPECT_TRUE(only(find_warnings(r), "from a run of 5 min"));
  EXPECT_TRUE(find_warnings(r, 0.0, WaveType::airy).empty());  // one wave after the other is the same
}

TEST(run_findings, a_record_that_is_another_from_some_time_on_has_no_extremes_of_three_hours) {
  DynamicResults r = sound();
  r.duration = 300.0;
  r.extremes[0].estimate.reset();
  r.non_stationary = "mooring line \"bow\" parted at t = 60.0 s";
  EXPECT_TRUE(
      only(find_warnings(r), "not stationary: mooring line \"bow\" parted at t = 60.0 s; there are no three-hour"));
}

TEST(run_findings, a_vessel_at_rest_in_a_sea_is_reported) {
  DynamicResults r = sound();
  r.histories[1].over_time = {};
  EXPECT_TRUE(only(find_warnings(r), "the vessel does not move in this sea"));
  r.station_s.clear();  // lines by themselves, which may have no vessel at all
  EXPECT_TRUE(find_warnings(r).empty());
  r = sound();
  r.histories[0].over_time = {};  // calm water
  EXPECT_TRUE(find_warnings(r).empty());
}

TEST(run_findings, a_mean_off_the_wanted_tension_is_reported_and_so_is_a_drift) {
  DynamicResults r = sound();
  r.tensioner.tension.mean = 240e3;
  EXPECT_TRUE(only(find_warnings(r), "4.0 % below the set tension of 250.0 kN"));
  EXPECT_TRUE(only(find_warnings(sound(), 8e3), "drifts: it rises by 8"));
  EXPECT_TRUE(only(find_warnings(sound(), -8e3), "drifts: it falls by"));
}

TEST(run_findings, an_energy_balance_that_does_not_close_is_reported) {
  DynamicResults r = sound();
  r.energy.throughput = 1e6;
  r.energy.error = 2e3;
  EXPECT_TRUE(only(find_warnings(r), "the energy balance of the run has an error of 0.002"));
  EXPECT_TRUE(only(find_warnings(r), "reduce analysis.dynamic.max_step"));  // there is no fixed step to omit
}

/// Travel that forgets where it was within ten seconds, rows half a second apart: a first-order process, whose standard
/// deviation has a standard error of half of sqrt(2 * 10 s / T) [bendat2010]: 13 % after 300 s, 4 % after an hour.
std::vector<double> travel_warnings(double duration) {
  Random random(5);
  const double kept = std::exp(-0.5 / 10.0);
  std::vector<double> values;
  double position = 0.0;
  for (int i = 0; i < static_cast<int>(2.0 * duration); ++i) {
    position = kept * position + (random.uniform() - 0.5);
    values.push_back(1.2 + position);
  }
  return values;
}

TEST(run_findings, a_tensioner_that_decides_is_reported_where_the_run_is_short_for_it) {
  Description d;
  d.environment.waves.front().type = WaveType::jonswap;
  const auto prescribed = [&](double duration, std::int64_t acted) {
    DynamicResults r = sound();
    r.duration = duration;
    r.tensioner.travel.std = 0.316;
    r.tensioner.pay_out_count = acted;
    warn_of_tensioner_uncertainty(d, travel_warnings(duration), r);
    return messages(r.findings);
  };
  EXPECT_TRUE(only(prescribed(300.0, 70), "acted 70 times in 5 min"));
  EXPECT_TRUE(only(prescribed(300.0, 70), "travel, 0.32 m, is known to"));
  EXPECT_TRUE(prescribed(300.0, 0).empty());
  EXPECT_TRUE(prescribed(3600.0, 800).empty());
  d.operation.type = OperationType::pull_ahead;  // travel is the way of the vessel
  EXPECT_TRUE(prescribed(300.0, 70).empty());
  d.operation.type = OperationType::none;
  EXPECT_FALSE(prescribed(300.0, 70).empty());
  d.environment.waves.front().type = WaveType::airy;  // the same again and again
  EXPECT_TRUE(prescribed(300.0, 70).empty());
}

/// Findings on the sea of Tp 8 s, peak at 0.785 rad/s, with RAOs of these frequencies.
std::vector<std::string> sea_warnings(Description d, std::vector<double> omegas, double duration) {
  WavesDescription& waves = d.environment.waves.front();
  waves.type = WaveType::pierson_moskowitz;
  waves.hs = 1.5;
  waves.tp = 8.0;
  d.environment.water_depth = 89.0;
  d.vessel.motion = VesselMotion::raos;
  d.vessel.raos.emplace();
  d.vessel.raos->omegas = std::move(omegas);
  DynamicResults r = sound();
  r.duration = duration;
  warn_of_sea(d, r);
  return messages(r.findings);
}

TEST(run_findings, raos_that_do_not_reach_the_waves_are_reported) {
  const Description d;
  EXPECT_TRUE(sea_warnings(d, {0.1, 1.0, 2.2}, 600.0).empty());
  // For Pierson-Moskowitz 1 - exp(-5/4 x^-4) lies above x peak frequencies: 99.9 % above 0.64, 8 % above 1.97.
  EXPECT_TRUE(only(sea_warnings(d, {0.1, 0.5}, 600.0), "100 % of the sea's variance lies above the highest frequency"));
  EXPECT_TRUE(only(sea_warnings(d, {0.1, 1.55}, 600.0), "8 % of the sea's variance lies above"));
  EXPECT_TRUE(only(sea_warnings(d, {0.8, 2.2}, 600.0), "lies below the lowest frequency of the RAOs, 0.8 rad/s"));
}

TEST(run_findings, a_sea_of_few_waves_that_comes_back_is_reported) {
  Description d;
  d.environment.waves.front().components = 8;
  EXPECT_TRUE(only(sea_warnings(d, {0.1, 1.0, 2.2}, 3600.0), "the sea of 8 waves repeats itself"));
  EXPECT_TRUE(sea_warnings(d, {0.1, 1.0, 2.2}, 60.0).empty());  // shorter than 30 periods
  d.environment.waves.front().components = 99;
  EXPECT_TRUE(sea_warnings(d, {0.1, 1.0, 2.2}, 10800.0).empty());
}

TEST(run_findings, a_hull_beyond_what_its_linear_restoring_holds_for_is_reported) {
  VesselDescription vessel;
  vessel.depth = 9.0;
  vessel.draught = 5.0;
  vessel.motion = VesselMotion::coupled;
  const auto prescribed = [&](double heave, double roll) {
    DynamicResults r = sound();
    r.histories[1].over_time = {-heave, 0.2, 0.0, 0.1};
    r.histories.push_back({"roll", "rad", "", {-0.1, roll, 0.0, 0.1}, {}, {}});
    warn_of_large_motion(vessel, r);
    return messages(r.findings);
  };
  EXPECT_TRUE(prescribed(1.9, 0.17).empty());
  EXPECT_TRUE(only(prescribed(2.1, 0.17), "heaves by up to 2.10 m"));
  EXPECT_TRUE(only(prescribed(1.9, 0.18), "heels by up to 10.3 deg"));
  vessel.motion = VesselMotion::raos;  // prescribed: no restoring
  EXPECT_TRUE(prescribed(2.1, 0.18).empty());
}

TEST(run_findings, a_trend_is_a_trend_only_beyond_chance) {
  EXPECT_NEAR(trend(swinging(4000, 5e3)), 5e3, 300.0);
  std::vector<double> noise;  // eight blocks that scatter
  for (std::size_t i = 0; i < 800; ++i) noise.push_back(i / 100 % 2 == 0 ? 1.0 : -1.0);
  EXPECT_EQ(trend(noise), 0.0);
  EXPECT_EQ(trend({}), 0.0);
}

}  // namespace
}  // namespace overbend
