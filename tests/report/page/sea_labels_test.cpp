#include "report/page/sea_labels.h"

#include <gtest/gtest.h>

#include "base/constants.h"

namespace overbend {
namespace {

WavesDescription waves(WaveType type) {
  WavesDescription group;
  group.type = type;
  group.hs = 2.0;
  group.tp = 8.0;
  group.gamma = 3.3;
  group.height = 1.5;
  group.period = 9.0;
  group.from = 240.0 * kDegree;
  return group;
}

TEST(sea_label, names_spectrum_height_period_direction_and_crests) {
  EXPECT_EQ(sea_label({waves(WaveType::none)}), "calm water");
  EXPECT_EQ(sea_label({}), "calm water");
  EXPECT_EQ(sea_label({waves(WaveType::jonswap)}), "JONSWAP, Hs 2 m, Tp 8 s, gamma 3.3, from 240 deg, long-crested");
  EXPECT_EQ(sea_label({waves(WaveType::airy)}), "regular Airy wave, height 1.5 m, period 9 s, from 240 deg");
  WavesDescription by_crossings = waves(WaveType::pierson_moskowitz);
  by_crossings.tz = 5.68;
  by_crossings.spreading = 6.0;
  EXPECT_EQ(sea_label({by_crossings}),
            "Pierson-Moskowitz, Hs 2 m, Tp 8 s from Tz 5.68 s, from 240 deg, spread as cos^2s with s = 6");
  EXPECT_EQ(sea_label({waves(WaveType::torsethaugen)}),
            "Torsethaugen, simplified, Hs 2 m, Tp 8 s, from 240 deg, long-crested");
  WavesDescription parts = waves(WaveType::ochi_hubble);
  parts.parts = {{2.0, 14.0, 3.0}, {1.5, 7.0, 1.4}};
  EXPECT_EQ(sea_label({parts}),
            "Ochi-Hubble, Hs 2 m, Tp 14 s, lambda 3 and Hs 1.5 m, Tp 7 s, lambda 1.4, from 240 deg, long-crested");
}

TEST(sea_label, names_each_group_and_the_height_of_all_together) {
  EXPECT_EQ(
      sea_label({waves(WaveType::jonswap), waves(WaveType::none), waves(WaveType::airy)}),
      "Hs 2 m together: JONSWAP, Hs 2 m, Tp 8 s, gamma 3.3, from 240 deg, long-crested; regular Airy wave, height "
      "1.5 m, period 9 s, from 240 deg");
  EXPECT_EQ(sea_label({waves(WaveType::none), waves(WaveType::none)}), "calm water");
}

TEST(sea_label, names_the_directions_of_a_file) {
  WavesDescription file = waves(WaveType::user);
  file.spectrum_file = "data/46990.data_spec";
  file.directions.from = {4.0, 4.1};
  file.directions.spreading = {3.0, 3.0};
  EXPECT_EQ(sea_label({file}), "spectrum of 46990.data_spec, mainly from 240 deg, spread as in the file");
}

}  // namespace
}  // namespace overbend
