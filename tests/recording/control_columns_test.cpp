#include "recording/control_columns.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

/// Pays out for two seconds and then leaves the machine to its brake.
class TwoSeconds : public Controller {
 public:
  MachineCommand command(const MachineReading& seen) override {
    if (seen.time >= 2.0 - 1e-9) return {};
    return {MachineCommand::Kind::speed, 0.1};
  }
};

TEST(control_columns, report_what_a_controller_asked_for_and_the_results_that_there_was_one) {
  Description d = testing::workable();
  d.dynamics->build_up = 0.0;
  d.dynamics->duration = 4.0;
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  d.tensioner.mode = TensionerMode::locked;
  const testing::TimedLay c(d);
  TwoSeconds controller;
  DynamicOptions options = dynamic_options(c.model);
  options.controllers = {{kTensionerMachine, &controller, 0.1}};
  testing::MemorySink sink;
  const DynamicResults results = c.run(sink, options).results.value();
  const std::vector<double> time = sink.column("time"), speed = sink.column("tensioner/speed"),
                            asked = sink.column("tensioner/commanded_speed"), travel = sink.column("tensioner/travel");
  ASSERT_EQ(speed.size(), time.size());
  for (std::size_t i = 0; i < time.size(); ++i) {
    EXPECT_NEAR(speed[i], time[i] > 0.2 && time[i] < 2.1 ? 0.1 : 0.0, 1e-12) << time[i];
    EXPECT_NEAR(asked[i], speed[i], 1e-12) << time[i];
  }
  EXPECT_NEAR(travel.back(), 0.2, 1e-12);
  EXPECT_EQ(sink.column("tensioner/set_tension").size(), time.size());
  EXPECT_TRUE(std::any_of(results.assumptions.begin(), results.assumptions.end(), [](const Assumption& assumption) {
    return assumption.text.find("commanded the tensioner") != std::string::npos;
  }));
  EXPECT_EQ(results.tensioner.pay_out_count, 1);

  testing::MemorySink without;
  c.run(without, dynamic_options(c.model));
  EXPECT_TRUE(without.column("tensioner/speed").empty());
}

}  // namespace
}  // namespace overbend
