/// A vessel of prescribed motion, moved ahead while its tensioner pays out.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "dynamics/run/simulation.h"
#include "recording/recorder.h"
#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"

namespace overbend {
namespace {

using testing::EmptySink;
using testing::MemorySink;
using testing::TimedLay;

/// In still water, with the tension kept: 4 m ahead from t = 1 s on.
Description moved() {
  Description d = testing::workable();
  d.environment.waves.front().type = WaveType::none;
  d.vessel.motion = VesselMotion::fixed;
  d.tensioner.mode = TensionerMode::constant;
  d.tensioner.range_low.reset();
  d.tensioner.range_high.reset();
  d.tensioner.travel.reset();
  d.tensioner.velocity = 0.6;
  d.operation.type = OperationType::pull_ahead;
  d.operation.distance = 4.0;
  d.operation.speed = 0.4;
  d.operation.acceleration_time = 4.0;
  d.operation.start = 1.0;
  d.dynamics->build_up = 0.5;
  d.dynamics->duration = 40.0;
  return d;
}

/// Rollers without friction: what they hold back along the pipe is no part of the static state.
Description slippery() {
  Description d = moved();
  for (RollerKindDescription& kind : d.rollers) kind.friction_axial = kind.friction_lateral = 0.0;
  return d;
}

struct Moved {
  explicit Moved(const Description& d)
      : c(d),
        simulation(c.model, c.start, c.statics.top_tension, dynamic_options(c.model)),
        recorder(c.model, c.statics, simulation, sink) {
    simulation.observe(recorder);
    before = recorder.pipe()->nodes();
    resting = reactions();
    EXPECT_TRUE(simulation.advance(simulation.end()));
  }
  TimedLay c;
  Simulation simulation;
  MemorySink sink;
  Recorder recorder;
  NodeValues before;
  std::vector<double> resting;

  /// Forces of the rollers on the pipe now [N].
  std::vector<double> reactions() const {
    std::vector<double> sizes;
    const Instant instant = simulation.present();
    for (const RollerContact& contact : instant.contacts()) sizes.push_back(contact.normal);
    return sizes;
  }
};

TEST(pull_ahead, pipe_lies_at_the_end_as_at_the_start) {
  const Moved moved(slippery());
  const NodeValues &before = moved.before, &after = moved.recorder.pipe()->nodes();
  ASSERT_EQ(after.x.size(), before.x.size());
  const double tension = before.effective_tension.back();
  const auto max_value = [](const std::vector<double>& all) { return *std::max_element(all.begin(), all.end()); };
  const double moment = max_value(before.bending_moment);
  EXPECT_NEAR(max_value(after.bending_moment), moment, 5e-3 * moment);
  for (std::size_t i = 0; i < before.x.size(); ++i) {
    EXPECT_NEAR(after.effective_tension[i], before.effective_tension[i], 1e-3 * tension) << i;
    // A kink over a roller, as the one at the bed, counts at the node nearest to it, and nodes have moved on.
    const bool suspended = before.z[i] > -75.0 && before.z[i] < -40.0;
    EXPECT_NEAR(after.bending_moment[i], before.bending_moment[i], suspended ? 5e-4 * moment : 3e-2 * moment) << i;
    EXPECT_NEAR(after.z[i], before.z[i], 0.02) << i;
  }
  const std::vector<double> reactions = moved.reactions();
  for (std::size_t i = 0; i < reactions.size(); ++i) {  // the clamp stands off by what has not become an element yet
    EXPECT_NEAR(reactions[i], moved.resting[i], 0.015 * max_value(moved.resting)) << i;
  }
  const Instant end = moved.simulation.present();
  EXPECT_NEAR(end.move.paid_out, 4.0, 0.02);
  EXPECT_NEAR(end.move.ahead_W.norm(), 4.0, 1e-12);
  EXPECT_LT(std::abs(end.drift), 1e-3);  // with the energy of what came in booked apart
  EXPECT_EQ(end.assembly->system().lines[0].mesh.s.size() * 6, end.pipe().q.size());
}

TEST(pull_ahead, results_do_not_depend_on_the_length_of_what_is_fed) {
  Description fine = slippery();
  fine.mesh.overbend_element = 0.6;
  const Moved a(slippery()), b(fine);
  const std::vector<double> x = a.sink.column("top_tension"), y = b.sink.column("top_tension");
  const std::vector<double> out = a.sink.column("tensioner/paid_out"), fed = b.sink.column("tensioner/paid_out");
  ASSERT_EQ(x.size(), y.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_NEAR(x[i], y[i], 0.02 * x[0]) << i;
    EXPECT_NEAR(out[i], fed[i], 0.02) << i;
  }
}

TEST(pull_ahead, resumes_in_the_middle_of_a_move_bit_for_bit) {
  Description d = moved();
  d.environment.waves = testing::workable().environment.waves;
  d.vessel.motion = testing::workable().vessel.motion;
  d.operation.speed = 0.8;
  d.dynamics->duration = 9.0;
  const TimedLay c(d);
  const DynamicOptions options = dynamic_options(c.model);
  EmptySink sink;
  Simulation whole(c.model, c.start, c.statics.top_tension, options);
  Recorder recorder(c.model, c.statics, whole, sink);
  whole.observe(recorder);
  ASSERT_TRUE(whole.advance(6.0));
  EXPECT_GT(whole.present().pipe().q.size(), 6 * recorder.pipe()->nodes().x.size());  // nodes have come in
  const DynamicCheckpoint checkpoint = whole.checkpoint();
  Simulation resumed(c.model, c.start, c.statics.top_tension, options);
  Recorder second_recorder(c.model, c.statics, resumed, sink);
  resumed.observe(second_recorder);
  resumed.restore(checkpoint);
  EXPECT_EQ(resumed.tension(), whole.tension());
  ASSERT_TRUE(whole.advance(9.0));
  ASSERT_TRUE(resumed.advance(9.0));
  EXPECT_EQ(resumed.present().pipe().q, whole.present().pipe().q);
  EXPECT_EQ(resumed.present().pipe().acc, whole.present().pipe().acc);
  EXPECT_EQ(resumed.present().move.paid_out, whole.present().move.paid_out);
  EXPECT_EQ(resumed.energy().error, whole.energy().error);
  EXPECT_EQ(second_recorder.pipe()->nodes().von_mises, recorder.pipe()->nodes().von_mises);
}

TEST(pull_ahead, says_what_it_was_too_short_for_and_what_cannot_pay_out) {
  Description d = moved();
  d.tensioner.mode = TensionerMode::locked;
  d.tensioner.travel = 1.5;
  d.operation.distance = 0.2;
  d.operation.moves = 2;
  d.dynamics->duration = 2.0;
  const Moved moved(d);
  DynamicResults results;
  moved.recorder.fill(results);
  const auto prescribed = [&](const std::string& part) {
    return std::ranges::any_of(messages(results.findings),
                               [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
  };
  ASSERT_FALSE(results.assumptions.empty());
  EXPECT_NE(results.assumptions.back().text.find("0.40 m ahead in 2 moves from t = 1 s on"), std::string::npos);
  EXPECT_TRUE(prescribed("the run is too short for the operation"));
  EXPECT_TRUE(prescribed("the tensioner is locked while the vessel moves"));
  EXPECT_TRUE(prescribed("the tensioner's travel of 1.50 m is not applied"));
}

}  // namespace
}  // namespace overbend
