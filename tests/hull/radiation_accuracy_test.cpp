#include "hull/radiation_accuracy.h"

#include <gtest/gtest.h>

#include "hull/made_radiation.h"

namespace overbend {
namespace {

TEST(radiation_judgement, the_fit_of_sound_files_is_within_a_per_cent) {
  const HydrodynamicData& barge = testing::bgl1_data();
  for (const Radiation kind : {Radiation::state_space, Radiation::convolution}) {
    const Radiated radiated = make_radiation(barge, kind);
    const std::vector<RadiationMisfit> misfits = radiation_misfits(radiated.model, barge, Sea{});
    ASSERT_EQ(misfits.size(), 6U);
    for (const RadiationMisfit& radiation_misfit : misfits)
      EXPECT_LT(std::max(radiation_misfit.added_mass, radiation_misfit.damping), 0.02) << radiation_misfit.mode;
    EXPECT_TRUE(misfit_findings(misfits).empty());
  }
}

TEST(radiation_judgement, a_mode_that_is_missed_by_a_known_share_is_reported_with_it) {
  HydrodynamicData data = testing::bgl1_data();
  const Radiated radiated = make_radiation(data, Radiation::state_space);
  double max_value = 0.0;
  for (const RadiationPoint& point : data.radiation) max_value = std::max(max_value, point.added_mass(2, 2));
  for (RadiationPoint& point : data.radiation)
    point.added_mass(2, 2) += 0.25 * max_value;  // then 0.25/1.25 of the largest
  const std::vector<RadiationMisfit> misfits = radiation_misfits(radiated.model, data, Sea{});
  EXPECT_NEAR(misfits[2].added_mass, 0.2, 0.02);
  const std::vector<std::string> warnings = messages(misfit_findings(misfits));
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("does not represent the hydrodynamic file in heave"), std::string::npos);
}

TEST(radiation_judgement, what_the_sea_does_not_excite_does_not_count) {
  HydrodynamicData data = testing::bgl1_data();
  const Radiated radiated = make_radiation(data, Radiation::state_space);
  for (RadiationPoint& point : data.radiation) point.damping(2, 2) *= point.omega > 1.5 ? 2.0 : 1.0;
  Sea swell;
  swell.depth = 89.0;
  WaveComponent wave;
  wave.omega = 0.7;
  wave.amplitude = 1.0;
  swell.components = {wave};
  EXPECT_LT(radiation_misfits(radiated.model, data, swell)[2].damping, 0.02);
  EXPECT_GT(radiation_misfits(radiated.model, data, Sea{})[2].damping, 0.02);
}

}  // namespace
}  // namespace overbend
