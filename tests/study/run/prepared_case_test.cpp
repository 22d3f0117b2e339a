#include "study/run/prepared_case.h"

#include <gtest/gtest.h>

#include "study/run/case.h"
#include "support/bgl1_in_time.h"
#include "support/moored_lay.h"
#include "support/us_units.h"

namespace overbend {
namespace {

class Nothing : public Controller {
 public:
  MachineCommand command(const MachineReading& /*seen*/) override { return {}; }
};

std::string input_with(const std::vector<ControllerUse>& controllers) {
  return std::get<0>(prepare_case(testing::workable(), controllers))->input;
}

TEST(prepared_case, is_another_input_with_controllers_and_with_each_machine_and_interval) {
  Nothing nothing;
  const std::string alone = input_with({});
  const std::string driven = input_with({{"tensioner", &nothing, 0.1}});
  EXPECT_NE(driven, alone);
  EXPECT_EQ(driven, input_with({{"tensioner", &nothing, 0.1}}));
  EXPECT_NE(driven, input_with({{"tensioner", &nothing, 0.2}}));
  EXPECT_NE(driven, input_with({{"bow", &nothing, 0.1}}));
}

TEST(prepared_case, of_a_hull_without_a_pipe_has_its_lines) {
  const Description barge = testing::coarse_example("moored-barge", 5.0, 2.0);
  const auto prepared = std::get<0>(prepare_case(barge));
  EXPECT_FALSE(prepared->statics.has_pipe());
  EXPECT_EQ(prepared->statics.title, barge.title);
  EXPECT_EQ(prepared->statics.moorings->rest.moorings.size(), 8U);
}

TEST(prepared_case, of_a_hull_that_floats_in_statics_alone_warns_that_it_will_not_in_time) {
  Description barge = testing::coarse_example("moored-barge", 5.0, 2.0);
  barge.vessel.motion = VesselMotion::fixed;
  barge.vessel.coupled.reset();
  barge.vessel.hydrostatics = HydrostaticsDescription{3.6e7, 2.1e9, 4.3e10};
  const auto prepared = std::get<0>(prepare_case(barge));
  const std::vector<std::string> warnings = messages(prepared->statics.findings);
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
    return warning.find("vessel.hydrostatics apply to statics only") != std::string::npos;
  }));
}

TEST(prepared_case, of_a_hull_depends_on_all_its_files_whichever_of_them_is_named) {
  Description barge = testing::coarse_example("moored-barge", 5.0, 2.0);
  const std::string by_stem = input_text(barge);
  barge.vessel.coupled->hydrodynamics += ".1";
  EXPECT_EQ(input_text(barge), by_stem);
}

TEST(prepared_case, of_cases_with_controllers_is_never_shared) {
  Nothing nothing;
  Case first, second;
  EXPECT_TRUE(same_model(first, second));
  second.controllers = {{"tensioner", &nothing, 0.1}};
  EXPECT_FALSE(same_model(first, second));
  first.controllers = second.controllers;
  EXPECT_FALSE(same_model(first, second));
}

TEST(prepared_case, a_stage_is_the_same_input_in_whichever_units_it_is_shown) {
  Description d;
  d.stage = LayStageDescription{};
  d.stage->name = "hold 2";
  d.stage->cable_out = 120.0;
  const std::string metric = input_text(d);
  {
    const UsUnits units;
    EXPECT_EQ(input_text(d), metric);
  }
  d.stage->cable_out = 120.0000001;
  EXPECT_NE(input_text(d), metric);
}

}  // namespace
}  // namespace overbend
