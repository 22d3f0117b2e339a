#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/constants.h"
#include "mechanics/sea.h"
#include "mechanics/wave_spectrum.h"

namespace overbend {
namespace {

WavesDescription jonswap(double hs, double tp, double gamma, double from_deg, std::optional<double> spreading = {}) {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  waves.hs = hs;
  waves.tp = tp;
  waves.gamma = gamma;
  waves.from = from_deg * kDegree;
  waves.spreading = spreading;
  return waves;
}

WavesDescription airy(double height, double period, double from_deg) {
  WavesDescription waves;
  waves.type = WaveType::airy;
  waves.height = height;
  waves.period = period;
  waves.from = from_deg * kDegree;
  return waves;
}

WaveGroups wind_sea_and_swell() {
  return {jonswap(2.2, 7.4, 3.0, 240.0, 8.0), jonswap(1.1, 13.5, 6.0, 300.0, 40.0)};
}

double moment(const Sea& sea, int n) {
  double sum = 0.0;
  for (const WaveComponent& c : sea.components) sum += 0.5 * c.amplitude * c.amplitude * std::pow(c.omega, n);
  return sum;
}

TEST(sea_of_groups, elevation_and_motion_of_the_water_are_the_sums_of_those_of_the_groups) {
  const WaveGroups groups = {jonswap(2.2, 7.4, 3.0, 240.0, 8.0), airy(1.0, 11.0, 20.0)};
  const Sea both = make_sea(groups, 60.0, 5);
  const Sea first = make_sea(groups[0], 60.0, 5), second = make_sea(groups[1], 60.0, 5);
  const BuildUp full;
  for (const double t : {0.0, 17.3, 401.0}) {
    EXPECT_NEAR(elevation(both, t, full, 30.0, -12.0),
                elevation(first, t, full, 30.0, -12.0) + elevation(second, t, full, 30.0, -12.0), 1e-12);
    std::array<WaterState, 1> a, b, c;
    const std::array<Vec3, 1> point = {
        Vec3(3.0, 4.0, -60.0)};  // on the bed, where stretching has no effect; short waves are left out there
    water_state(both, t, full, point, a);
    water_state(first, t, full, point, b);
    water_state(second, t, full, point, c);
    EXPECT_LT((a[0].velocity - b[0].velocity - c[0].velocity).norm(), 1e-4);
    EXPECT_LT((a[0].acceleration - b[0].acceleration - c[0].acceleration).norm(), 1e-4);
  }
}

TEST(sea_of_groups, a_list_of_one_group_is_the_sea_of_that_group_bit_for_bit) {
  const WavesDescription waves = jonswap(2.2, 7.4, 3.0, 240.0, 8.0);
  const Sea alone = make_sea(waves, 60.0, 9), listed = make_sea(WaveGroups{waves}, 60.0, 9);
  ASSERT_EQ(alone.components.size(), listed.components.size());
  for (std::size_t i = 0; i < alone.components.size(); ++i) {
    EXPECT_EQ(alone.components[i].phase, listed.components[i].phase);
    EXPECT_EQ(alone.components[i].kx, listed.components[i].kx);
  }
}

TEST(sea_of_groups, components_are_in_order_of_their_wave_number) {
  const Sea sea = make_sea(wind_sea_and_swell(), 60.0, 1);
  EXPECT_EQ(sea.components.size(), 400U);
  EXPECT_TRUE(std::is_sorted(sea.components.begin(), sea.components.end(),
                             [](const auto& a, const auto& b) { return a.wave_number < b.wave_number; }));
  EXPECT_EQ(highest_frequency(sea), sea.components.back().omega);
}

TEST(sea_of_groups, moments_are_those_of_the_spectra_together) {
  EXPECT_NEAR(significant_height(wind_sea_and_swell()), 2.4596747752, 1e-9);
  double m1 = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Sea sea = make_sea(wind_sea_and_swell(), 60.0, seed);
    EXPECT_NEAR(moment(sea, 0), 0.378125, 1e-9);
    m1 += 0.1 * moment(sea, 1);
  }
  EXPECT_NEAR(m1 / 0.35038926739, 1.0, 0.01);
  const WaveGroups equal = {jonswap(1.5, 6.5, 3.3, 0.0), jonswap(1.5, 11.0, 3.3, 90.0)};
  EXPECT_NEAR(significant_height(equal), 2.1213203436, 1e-9);
  EXPECT_NEAR(moment(make_sea(equal, 60.0, 3), 0), 0.28125, 1e-9);
}

TEST(sea_of_groups, each_group_keeps_its_direction) {
  const Sea sea = make_sea(WaveGroups{jonswap(1.5, 6.5, 3.3, 0.0), jonswap(1.5, 11.0, 3.3, 90.0)}, 60.0, 3);
  double from_north = 0.0, from_east = 0.0;
  for (const WaveComponent& c : sea.components) {
    const double energy = 0.5 * c.amplitude * c.amplitude;
    if (std::abs(c.kx) < 1e-12 && c.ky < 0.0) from_north += energy;
    if (std::abs(c.ky) < 1e-12 && c.kx < 0.0) from_east += energy;
  }
  EXPECT_NEAR(from_north, 0.140625, 1e-9);
  EXPECT_NEAR(from_east, 0.140625, 1e-9);
}

std::vector<double> phases_of_group(WaveGroups groups, std::size_t index, std::uint64_t seed) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    if (i != index) groups[i].hs = 1e-9;  // its amplitudes distinguish it
  }
  std::vector<double> phases;
  for (const WaveComponent& c : make_sea(groups, 60.0, seed).components) {
    if (c.amplitude > 1e-6) phases.push_back(c.phase);
  }
  return phases;
}

TEST(sea_of_groups, equal_seeds_in_two_groups_give_different_phases) {
  const WaveGroups alike = {jonswap(1.5, 8.0, 3.3, 0.0), jonswap(1.5, 8.0, 3.3, 0.0)};
  EXPECT_NE(phases_of_group(alike, 0, 1), phases_of_group(alike, 1, 1));
}

TEST(sea_of_groups, the_seed_of_a_run_varies_all_groups_and_that_of_one_group_only_this_one) {
  WaveGroups groups = wind_sea_and_swell();
  const std::vector<double> first = phases_of_group(groups, 0, 1), second = phases_of_group(groups, 1, 1);
  EXPECT_NE(phases_of_group(groups, 0, 2), first);
  EXPECT_NE(phases_of_group(groups, 1, 2), second);
  groups[1].seed = 7;
  EXPECT_EQ(default_seed(groups), 1U);
  EXPECT_EQ(phases_of_group(groups, 0, default_seed(groups)), first);
  EXPECT_NE(phases_of_group(groups, 1, default_seed(groups)), second);
  groups = wind_sea_and_swell();
  groups[0].seed = 5;
  EXPECT_EQ(phases_of_group(groups, 1, default_seed(groups)), second);
}

TEST(sea_of_groups, seeds_of_a_run_are_those_of_the_first_random_group) {
  WaveGroups groups = {airy(1.0, 8.0, 0.0), jonswap(1.0, 8.0, 3.3, 0.0)};
  groups[1].seed = 12;
  EXPECT_EQ(default_seed(groups), 12U);
  EXPECT_EQ(default_seed({}), 1U);
}

TEST(sea_of_groups, a_stokes_wave_is_alone) {
  WavesDescription stokes = airy(3.0, 9.0, 0.0);
  stokes.type = WaveType::stokes5;
  EXPECT_TRUE(make_sea(stokes, 60.0, 1).nonlinear);
  EXPECT_THROW(make_sea(WaveGroups{stokes, airy(1.0, 8.0, 0.0)}, 60.0, 1), std::invalid_argument);
  EXPECT_THROW(make_sea(WaveGroups{airy(1.0, 8.0, 0.0), stokes}, 60.0, 1), std::invalid_argument);
  WavesDescription none;
  EXPECT_TRUE(make_sea(WaveGroups{none, stokes}, 60.0, 1).nonlinear);
}

TEST(sea_of_groups, groups_of_type_none_add_nothing) {
  EXPECT_TRUE(make_sea(WaveGroups{WavesDescription{}, WavesDescription{}}, 60.0, 1).calm());
  EXPECT_TRUE(make_sea(WaveGroups{}, 60.0, 1).calm());
  EXPECT_TRUE(is_calm({WavesDescription{}}));
  EXPECT_EQ(make_sea(WaveGroups{WavesDescription{}, airy(1.0, 8.0, 0.0)}, 60.0, 1).components.size(), 1U);
}

}  // namespace
}  // namespace overbend
